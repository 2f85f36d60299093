// Sizes of defects where the question is defined to the last pose: loops, free spin, second order, small
// turns.
#include "verify/studies/programs/subject.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::verify {
namespace {

using V = Vec3<double>;

constexpr double kTenth = 0.1;
constexpr const char* kTwoDigits = "printed with two digits, some loops summed in single precision";

/// As the programs themselves were measured: work over path round the loops, K_m = 10 or (1, 10, 100), and
/// with forces, K_f = 100, K_m = 10.
struct Loops {
  const char* joint;
  double one, three, six;
};
constexpr double kNone = 0;

constexpr Loops kLoops[] = {
    {"simbody_xyz", kNone, kNone, kNone},       {"bullet_6dof", -.011, -.011, -.0020},
    {"bullet_6dof_at_b", -.011, -.011, -.0020}, {"bullet_default", .21, -.011, .025},
    {"dart_free", kNone, -.042, .13},           {"physx_swing_twist", -.40, -.22, -.059},
    {"jolt_6dof", kNone, -.042, kNone},         {"rapier_asin", 4.2e-4, .040, 5.4e-5},
    {"ode_amotor", .0064, .0065, 5.5e-4},       {"havok", -.015, .025, -.0020},
};

Finding loop_finding(const char* what, const char* joint, double measured, double expected) {
  Draft f = program_finding(what, joint).measured(measured).in("relative");
  if (expected == kNone)
    f.equal(0, kDoubleRounding, kDoubleRoundingReason);
  else
    f.equal(expected, kTenth * std::abs(expected), kTwoDigits);
  return f.by(Oracle::other_program, 0.05 * std::abs(expected));
}

std::vector<Finding> loops(const Loops& l) {
  const auto answer = program_subject(l.joint);
  const V none(0, 0, 0), ten(10, 10, 10), three(1, 10, 100), hundred(100, 100, 100);
  // The share of the path that a linear joint swallows does not depend on how stiff it is.
  const double twice = loop_work(answer, hundred * 2, ten * 2, true),
               once = loop_work(answer, hundred, ten, true);
  return {program_finding("loop_measured/stiffer", l.joint)
              .measured(std::abs(twice - once))
              .in("relative")
              .at_most(kDoubleRounding, kDoubleRoundingReason)
              .by(Oracle::closed_form),
          loop_finding("loop_measured/one", l.joint, loop_work(answer, none, ten, false), l.one),
          loop_finding("loop_measured/three", l.joint, loop_work(answer, none, three, false), l.three),
          loop_finding("loop_measured/six", l.joint, loop_work(answer, hundred, ten, true), l.six)};
}

/// A shaft that spins freely while it is bent. `any` of the shafts: some laws have a best one.
struct Spin {
  const char* joint;
  int shaft;
  double low, high;  ///< 0, x: at most x
  const char* why;
};

constexpr const char* kPrinted =
    "printed with two or three digits; two turns are sampled at twenty angles, near pi too";
constexpr Spin kSpins[] = {
    {"abaqus_bushing", 2, 0, 1e-12, "flexion and torsion part exactly"},
    {"bullet_6dof", 0, 0, .007, kPrinted},
    {"bullet_6dof", 2, 0, .007, kPrinted},
    {"simbody_xyz", 0, 0, .007, kPrinted},
    {"simbody_xyz", 2, 0, .007, kPrinted},
    {"physx_swing_twist", 0, .006, .0075, kPrinted},
    {"quaternion", 0, .006, .0075, kPrinted},
    {"newton_rod", 2, .0125, .0135, kPrinted},
    {"invariant", 0, .57, .585, kPrinted},
    {"jointc", 0, .95, 1.05, kPrinted},
    {"jolt_6dof", 0, 1.40, 1.42, kPrinted},
    {"rapier_asin", 0, 1.40, 1.42, kPrinted},
    {"attached_a", 0, 1.80, 1.87, kPrinted},
    {"attached_b", 0, 1.80, 1.87, kPrinted},
    {"mbsim_offdiag", 0, 1.98, 2.0, kPrinted},
};

Finding spin(const Spin& s) {
  Draft f = program_finding(fmt::format("free_spin/{}", "xyz"[s.shaft]), s.joint)
                .measured(free_spin(program_subject(s.joint), s.shaft))
                .in("relative");
  if (s.low == 0) return f.at_most(s.high, s.why).by(Oracle::independent);
  return f.equal((s.low + s.high) / 2, (s.high - s.low) / 2, s.why).by(Oracle::independent);
}

/// m = K theta + theta x K theta / 2 + (b1 th2 th3, ...): b of K = (2, 3, 7).
struct Order {
  const char* joint;
  V b;
};
const Order kOrders[] = {
    {"attached_a", {-2, 2.5, -.5}},  {"invariant", {0, 0, 0}},        {"abaqus_bushing", {0, 0, 0}},
    {"bullet_6dof", {3, 3, 3}},      {"newton_d6", {4, -3, -1}},      {"physx_swing_twist", {-2, 1, 3}},
    {"jolt_6dof", {2, -2.5, .5}},    {"rapier_asin", {-2, 2.5, -.5}}, {"mbsim_offdiag", {-1, 4, 3}},
    {"febio_generic", {-6, -6, -6}}, {"newton_rod", {.5, .5, .5}},    {"ode_amotor", {-3, -3, -3}},
    {"havok", {-2, 2.5, -.5}},       {"quaternion", {0, 0, 0}},       {"dart_free", {2, -2.5, .5}},
};

std::vector<Finding> order(const Order& o) {
  const auto seen = second_order(program_subject(o.joint));
  constexpr const char* kWhy =
      "second differences in double, extrapolated: h^4 of 2e-3 and rounding over h^2";
  return {program_finding("second_order", o.joint)
              .measured(largest_entry<double>(V(seen.b - o.b)))
              .in("N m")
              .at_most(1e-6, kWhy)
              .by(Oracle::closed_form),
          program_finding("second_order_remainder", o.joint)
              .measured(larger(seen.residual, seen.first_defect))
              .in("relative")
              .at_most(1e-6, kWhy)
              .by(Oracle::closed_form)};
}

/// Moment over angle of small turns about each axis, K_m = I: the stiffness asked for, but for these.
struct Share {
  std::string_view joint;
  double of_asked;
};
constexpr Share kShares[] = {{"physx_slerp", 1. / 4}, {"mujoco_weld", 1. / 8}};

Finding share(const reference::ProgramJoint& joint) {
  const auto* other = std::ranges::find(kShares, joint.name, &Share::joint);
  const double expected = other == std::end(kShares) ? 1 : other->of_asked;
  const auto answer = program_subject(joint.name);
  constexpr double kSmall = 1e-3;
  Measurement off;
  double farthest = NAN;
  for (int axis = 0; axis < 3; ++axis) {
    const double seen = secant_stiffness(answer, axis, kSmall);
    if (off.include(std::abs(seen - expected), "")) farthest = seen;
  }
  return program_finding("stiffness", joint.name)
      .measured(farthest)
      .in("of that asked for")
      .equal(expected, kSmall * kSmall, "moments are odd in the angle: the rest is of its square, 1e-6")
      .by(Oracle::closed_form);
}

/// From a millionth to a tenth of a radian: neither no stiffness at zero nor twice.
Finding share_at_any_angle(const reference::ProgramJoint& joint) {
  const auto* other = std::ranges::find(kShares, joint.name, &Share::joint);
  const double expected = other == std::end(kShares) ? 1 : other->of_asked;
  const auto answer = program_subject(joint.name);
  Measurement worst;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double phi : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1})
      worst.include(std::abs(secant_stiffness(answer, axis, phi) / expected - 1) / (phi * phi + 1e-9),
                    fmt::format("about {} at {} rad", "xyz"[axis], phi));
  }
  return program_finding("stiffness_at_any_angle", joint.name)
      .measured(worst)
      .in("of the angle squared, and 1e-9")
      .at_most(1,
               "moments are odd, sin and tan off by half the square at most; rounding over 1e-6 rad is 1e-10")
      .by(Oracle::closed_form);
}

}  // namespace

void program_loops(Checks& checks) {
  for (const Loops& l : kLoops)
    checks.push_back({fmt::format("programs/loops/{}", l.joint), "", [&l] { return loops(l); }});
}

void program_free_spin(Checks& checks) {
  for (const Spin& s : kSpins) {
    checks.push_back({fmt::format("programs/{}/free_spin_{}", s.joint, "xyz"[s.shaft]), "",
                      [&s] { return std::vector{spin(s)}; }});
  }
}

void program_second_order(Checks& checks) {
  for (const Order& o : kOrders)
    checks.push_back(
        {fmt::format("programs/{}/second_order_moments", o.joint), "", [&o] { return order(o); }});
}

void program_stiffness(Checks& checks) {
  for (const auto& joint : reference::program_joints()) {
    if (joint.facts.is_bond) continue;  // without its line it has no rotation
    checks.push_back({fmt::format("programs/stiffness/{}", joint.name), "", [&joint] {
                        return std::vector{share(joint), share_at_any_angle(joint)};
                      }});
  }
}

}  // namespace halfway::verify
