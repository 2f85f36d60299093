// What a user sees: two free bodies on a joint that spin up by themselves, and a motion that changes when the
// bodies are renamed.
#include "verify/studies/programs/subject.hpp"

namespace halfway::verify {
namespace {

using reference::Answerer;
using reference::Ask;
using reference::part;
using reference::times;
using V = Vec3<double>;

/// Two balls of 1 kg and 1 kg m2, at rest first.
struct Motion {
  Ask at;
  V v_a = V::Zero(), v_b = V::Zero(), w_a = V::Zero(), w_b = V::Zero();

  /// Spin and orbit about the centre of mass, which does not move when forces balance.
  V angular_momentum() const {
    const V d = at.b.x - at.a.x;
    return w_a + w_b + d.cross(v_b - v_a) / 2;
  }
};

void move(Motion& m, double dt) {
  const auto turn = [&](reference::AskedBody& body, const V& v, const V& w) {
    body.x += dt * v;
    body.q = times(reference::quaternion_of(dt * w), body.q).normalized();
  };
  turn(m.at.a, m.v_a, m.w_a);
  turn(m.at.b, m.v_b, m.w_b);
}

/// Leapfrog: reversible, so that what grows is the joint's doing.
void run(Motion& m, const Answerer& joint, double seconds) {
  const double step = is_quick() ? 4e-3 : 1e-3;
  for (double t = 0; t < seconds && m.at.b.x.allFinite(); t += step) {
    move(m, step / 2);
    const auto q = joint(m.at);
    m.v_a -= step * part(q, 0), m.w_a -= step * part(q, 1), m.v_b -= step * part(q, 2),
        m.w_b -= step * part(q, 3);
    move(m, step / 2);
  }
}

Motion started(const programs::ProgramFacts& facts) {
  Motion m;
  m.at.K_f = facts.isotropic_forces ? V(10, 10, 10).asDiagonal() : V(1, 10, 100).asDiagonal();
  m.at.K_m = facts.isotropic_moments ? V(10, 10, 10).asDiagonal() : V(3, 10, 30).asDiagonal();
  m.at.is_bond = facts.is_bond;
  if (facts.is_bond) m.at.K_f = V(10, 10, 100).asDiagonal(), m.at.K_m = V(10, 10, 30).asDiagonal();
  m.at.a.o = V(.2, .1, -.1), m.at.b.o = V(-.1, .2, .15);
  m.at.a.h = reference::quaternion_of(V(.4, -.3, .2)), m.at.b.h = reference::quaternion_of(V(-.2, .5, .3));
  reference::place_b(m.at, V(.3, -.2, .4), facts.is_bond ? V(.2, .1, 1.1) : V(.2, -.1, .15));
  return m;
}

/// Angular momentum that two free bodies won, over the largest spin of one: none, whatever the joint, if
/// moments balance.
double spun_up(const Answerer& joint, const programs::ProgramFacts& facts) {
  Motion m = started(facts);
  const V before = m.angular_momentum();
  double largest = 0;
  for (int i = 0; i < 20; ++i) {
    run(m, joint, 0.1);
    keep_largest(largest, m.w_a.norm());
    keep_largest(largest, m.w_b.norm());
  }
  return (m.angular_momentum() - before).norm() / largest;
}

/// How far the bodies are from where they are when they had each other's names, after two seconds, m.
double renamed(const Answerer& joint, const programs::ProgramFacts& facts) {
  Motion one = started(facts), other = one;
  std::swap(other.at.a, other.at.b);
  if (facts.is_bond)
    for (auto* body : {&other.at.a, &other.at.b}) body->h = times(body->h, Eigen::Vector4d::Unit(1));
  run(one, joint, 2);
  run(other, joint, 2);
  return larger((one.at.a.x - other.at.b.x).norm(), (one.at.b.x - other.at.a.x).norm());
}

/// A law that is the same after the exchange, exactly, moves the bodies alike to rounding of 2000 steps.
constexpr double kAlike = 1e-9;
constexpr const char* kAlikeReason = "2000 steps of some fifty roundings, a hundredfold by the motion itself";

/// Momentum of the two, over the larger one's: none.
double drifted(const Answerer& joint, const programs::ProgramFacts& facts) {
  Motion m = started(facts);
  run(m, joint, 2);
  return (m.v_a + m.v_b).norm() / larger(m.v_a.norm(), m.v_b.norm());
}

std::vector<Finding> seen(const reference::ProgramJoint& joint) {
  const auto answer = program_subject(joint.name);
  const Finding drift = program_finding("drifts", joint.name)
                            .measured(drifted(answer, joint.facts))
                            .in("relative")
                            .at_most(kAlike, kAlikeReason)
                            .by(Oracle::closed_form);
  Draft spin = program_finding("spins_up", joint.name).measured(spun_up(answer, joint.facts)).in("relative");
  Draft name = program_finding("renamed", joint.name).measured(renamed(answer, joint.facts)).in("m");
  if (joint.facts.balanced)
    spin.at_most(kAlike, kAlikeReason).by(Oracle::closed_form);
  else
    spin.at_least(1e-2, "d x f, unbalanced, turns both bodies").by(Oracle::independent);
  if (joint.facts.order_free)
    name.at_most(kAlike, kAlikeReason).by(Oracle::closed_form);
  else
    name.at_least(1e-4, "another law for the same bodies").by(Oracle::independent);
  return {drift, spin, name};
}

}  // namespace

void program_motion(Checks& checks) {
  for (const auto& joint : reference::program_joints()) {
    if (joint.name == "mujoco_free") continue;  // a spring to the world
    checks.push_back({fmt::format("programs/motion/{}", joint.name), "", [&joint] { return seen(joint); }});
  }
}

}  // namespace halfway::verify
