#include "reference/mechanism/motion/moving_scene.hpp"

#include "halfway/systems/potentials.hpp"
#include "reference/mechanism/node_load.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace halfway::reference::mechanism {
namespace {

dynamics::Vec4 quaternion_of(const Mat3<double>& R) {
  const auto q = so3::quaternion<double>(R);
  return {q.w, q.v[0], q.v[1], q.v[2]};
}

/// A load's multiplier: straight between its times, and as at the nearest beyond them.
double multiplier(const BodyLoad& load, double time, double on_part) {
  if (load.times.empty()) return 1;
  const auto after = std::ranges::upper_bound(load.times, on_part);
  if (after == load.times.begin()) return load.factors.front();
  if (after == load.times.end()) return load.factors.back();
  const std::size_t i = std::size_t(after - load.times.begin());
  const double share = (time - load.times[i - 1]) / (load.times[i] - load.times[i - 1]);
  return load.factors[i - 1] + share * (load.factors[i] - load.factors[i - 1]);
}

}  // namespace

MovingScene::MovingScene(const MechanismScene& scene, const Choice& choice,
                         const std::vector<Pose<double>>& begin)
    : scene_(scene), entry_(*choice.entry) {
  for (const auto& pose : initial_poses<double>(scene)) rest_.push_back(*pose);
  for (const SceneJoint& joint : scene.joints) {
    specs_.push_back(joint.spec);
    specs_.back().xi = choice.xi;
  }
  for (const SceneBody& body : scene.bodies) add_body(body);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) add_start(scene.bodies[i], begin[i]);
  for (const BodyLoad& load : scene.loads) {
    const JointEnd<double> node{Vec3<double>::Zero(), rest_[std::size_t(load.body)].R.transpose()};
    loads_.push_back(
        joint_load<double>(Kind::linear_angular, on_node<double>(load), Mat3<double>::Identity(), node));
  }
  using dynamics::Loads, dynamics::State;
  system_.loads = [this](const State& s, Loads& sum) { set_loads(s, sum); };
  system_.strain_energy = [this](const State& s) { return strain_energy(s); };
  system_.dissipation = [this](const State& s) { return dissipation(s); };
}

void MovingScene::add_body(const SceneBody& body) {
  Mass mass;
  dynamics::Body out{1, Vec3<double>::Ones(), !body.moves};
  if (body.moves && *body.moves != Kind::angular) out.mass = body.mass, mass.center = body.center;
  if (body.moves && *body.moves != Kind::linear) {
    const Mat3<double> c = skew<double>(body.center - mass.center);
    const Mat3<double> J = body.inertia - body.mass * c * c;
    const Eigen::SelfAdjointEigenSolver<Mat3<double>> principal(J);
    const bool is_principal = J.isDiagonal(0);
    out.inertia = is_principal ? Vec3<double>(J.diagonal()) : principal.eigenvalues();
    if (!is_principal) mass.axes = principal.eigenvectors();
    if (mass.axes.determinant() < 0) mass.axes.col(0) *= -1;
  }
  system_.bodies.push_back(out);
  masses_.push_back(mass);
}

void MovingScene::add_start(const SceneBody& body, const Pose<double>& node) {
  const SceneStart& start = body.start;
  const std::size_t i = start_.size();
  const Mass& mass = masses_[i];
  const Vec3<double> spin = start.is_spin_of_body ? Vec3<double>(node.R * start.spin) : start.spin;
  const Vec3<double> arm = node.R * mass.center;
  dynamics::BodyState& out = start_.emplace_back();
  out.x = node.x + arm;
  out.q = quaternion_of(node.R * mass.axes);
  dynamics::set_motion(system_.bodies[i], start.velocity + spin.cross(arm), spin, out);
  if (!body.moves || *body.moves == Kind::angular) out.p.setZero();
}

Moving MovingScene::moving(const dynamics::State& state) const {
  Moving out;
  for (std::size_t i = 0; i < state.size(); ++i) {
    const dynamics::Body& body = system_.bodies[i];
    Pose<double> node = rest_[i];
    Twist<double> twist;
    if (!body.clamped) {
      node.R = dynamics::orientation(state[i].q) * masses_[i].axes.transpose();
      const Vec3<double> arm = node.R * masses_[i].center;
      node.x = state[i].x - arm;
      twist.w = dynamics::spin(body, state[i]);
      twist.v = dynamics::velocity(body, state[i]) - twist.w.cross(arm);
    }
    out.nodes.push_back(node);
    out.twists.push_back(twist);
  }
  return out;
}

Damping<double> MovingScene::damper(std::size_t j, const Moving& now) const {
  const SceneJoint& joint = scene_.joints[j];
  const std::size_t a = std::size_t(joint.a), b = std::size_t(joint.b);
  return by_kind(joint.spec.kind, [&](auto kind) {
    constexpr int n = strain_count(kind());
    const Eigen::Matrix<double, n, n> C = joint.damping;
    return damping<kind()>(StrainRate{Potential{}}, C, joint.spec.a, joint.spec.b, now.nodes[a], now.nodes[b],
                           now.twists[a], now.twists[b]);
  });
}

Eigen::Matrix<double, 12, 1> MovingScene::joint_loads(std::size_t j, const Moving& now) const {
  const SceneJoint& joint = scene_.joints[j];
  const auto elastic = node_loads<double>(entry_, specs_[j], now.nodes[std::size_t(joint.a)],
                                          now.nodes[std::size_t(joint.b)], false);
  if (joint.damping.size() == 0) return elastic.q;
  return elastic.q + damper(j, now).q;
}

double MovingScene::joint_power(std::size_t j, const Moving& now) const {
  return scene_.joints[j].damping.size() == 0 ? 0 : damper(j, now).law_power;
}

Vec3<double> MovingScene::relative_rotation(std::size_t j, const Moving& now) const {
  const SceneJoint& joint = scene_.joints[j];
  const Mat3<double> P_a = now.nodes[std::size_t(joint.a)].R * joint.spec.a.H,
                     P_b = now.nodes[std::size_t(joint.b)].R * joint.spec.b.H;
  return so3::log<double>(P_a.transpose() * P_b);
}

void MovingScene::add_to_body(std::size_t i, const Pose<double>& node, const Vec3<double>& f,
                              const Vec3<double>& m, dynamics::Loads& sum) const {
  const auto& moves = scene_.bodies[i].moves;
  if (!moves) return;
  const long at = 6 * long(i);
  if (*moves != Kind::angular) sum.segment<3>(at) += f;
  if (*moves != Kind::linear) sum.segment<3>(at + 3) += m - (node.R * masses_[i].center).cross(f);
}

void MovingScene::set_loads(const dynamics::State& state, dynamics::Loads& sum) const {
  sum.setZero(6 * long(state.size()));
  const Moving now = moving(state);
  for (std::size_t j = 0; j < specs_.size(); ++j) {
    const auto q = joint_loads(j, now);
    const std::size_t a = std::size_t(scene_.joints[j].a), b = std::size_t(scene_.joints[j].b);
    add_to_body(a, now.nodes[a], q.segment<3>(0), q.segment<3>(3), sum);
    add_to_body(b, now.nodes[b], q.segment<3>(6), q.segment<3>(9), sum);
  }
}

void MovingScene::set_drive(double time, double on_part, const dynamics::State& state,
                            dynamics::Loads& sum) const {
  sum.setZero(6 * long(state.size()));
  const Moving now = moving(state);
  for (std::size_t i = 0; i < loads_.size(); ++i) {
    const std::size_t body = std::size_t(scene_.loads[i].body);
    const Mat3<double> turned = now.nodes[body].R * rest_[body].R.transpose();
    const auto load = applied<Kind::linear_angular>(loads_[i], turned).load;
    const double times = multiplier(scene_.loads[i], time, on_part);
    add_to_body(body, now.nodes[body], times * load.head<3>(), times * load.tail<3>(), sum);
  }
}

double MovingScene::dissipation(const dynamics::State& state) const {
  const Moving now = moving(state);
  double sum = 0;
  for (std::size_t j = 0; j < specs_.size(); ++j) sum += joint_power(j, now);
  return sum;
}

double MovingScene::strain_energy(const dynamics::State& state) const {
  const Moving now = moving(state);
  double sum = 0;
  for (std::size_t j = 0; j < specs_.size(); ++j)
    sum += stored_energy(entry_, specs_[j], now.nodes[std::size_t(scene_.joints[j].a)],
                         now.nodes[std::size_t(scene_.joints[j].b)]);
  return sum;
}

dynamics::Momenta MovingScene::momenta(const dynamics::State& state) const {
  dynamics::Momenta out{Vec3<double>::Zero(), Vec3<double>::Zero()};
  for (std::size_t i = 0; i < state.size(); ++i) {
    const SceneBody& body = scene_.bodies[i];
    if (!body.moves) continue;
    Vec3<double> p = state[i].p, L = state[i].L;
    if (*body.moves == Kind::angular) {  // its angular momentum is about the node, and its centre moves
      const Vec3<double> arm = dynamics::orientation(state[i].q) * masses_[i].axes.transpose() * body.center;
      p = body.mass * dynamics::spin(system_.bodies[i], state[i]).cross(arm);
    }
    out.linear += p;
    out.angular += L + state[i].x.cross(p);
  }
  return out;
}

}  // namespace halfway::reference::mechanism
