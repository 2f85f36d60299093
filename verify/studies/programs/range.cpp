// Turns about one axis, past 90 degrees: where measures fold, jump or go on.
#include "verify/studies/programs/subject.hpp"

#include <numbers>

namespace halfway::verify {
namespace {

using reference::part;
using V = Vec3<double>;

/// Moment on b of a turn of b, K_m = 1, as measured of the programs and printed.
struct Turn {
  const char* joint;
  V axis;
  double degrees;
  V moment;
  double tolerance;
};

const V kX(1, 0, 0), kY(0, 1, 0), kZ(0, 0, 1);
const double kRight = std::numbers::pi / 180;

/// Past 90 degrees about the middle axis the angles of Simbody, Bullet and ODE depend on the sign of a
/// rounded zero. `phi` goes on; `sin` folds at 90; `2 sin(phi/2)` flattens.
const Turn kTurns[] = {
    {"simbody_xyz", kY, 89, 1.5533 * kY, 1e-3},
    {"bullet_6dof", kY, 89, 1.5533 * kY, 1e-3},
    {"ode_amotor", kY, 89, 1.5533 * kY, 1e-3},
    {"attached_b", kZ, 179, 179 * kRight* kZ, 1e-9},
    {"havok", kY, 179, 179 * kRight* kY, 1e-9},
    {"rapier_asin", kY, 120, 120 * kRight* kY, 1e-9},
    {"physx_swing_twist", kY, 30, .5 * kY, 1e-9},
    {"physx_swing_twist", kZ, 120, std::sin(120 * kRight) * kZ, 1e-9},
    {"physx_slerp", kZ, 90, .25 * kZ, 1e-9},
    {"jolt_6dof", kZ, 120, 2 * std::sin(60 * kRight) * kZ, 1e-9},
    {"ode_fixed", kX, 179, 2 * std::sin(89.5 * kRight) * kX, 1e-9},
};

Finding held(const Turn& t, std::size_t i) {
  reference::Ask ask;
  ask.K_f = ask.K_m = Mat3<double>::Identity();
  ask.b.q = reference::quaternion_of(t.degrees * kRight * t.axis);
  const V m = part(program_subject(t.joint)(ask), 3);
  return program_finding(fmt::format("turn/{}/{}", i, t.degrees), t.joint)
      .measured(largest_entry<double>(V(m - t.moment)))
      .in("N m")
      .at_most(t.tolerance, "as printed, or to rounding where the curve is a function with a name")
      .by(t.tolerance < 1e-6 ? Oracle::closed_form : Oracle::other_program);
}

std::vector<Finding> turns() {
  std::vector<Finding> out;
  for (std::size_t i = 0; i < std::size(kTurns); ++i) out.push_back(held(kTurns[i], i));
  return out;
}

/// Body b turned about one axis from 0 through two turns, its quaternion going on as it is: where and by how
/// much the moment jumps.
struct Jump {
  const char* joint;
  V axis;
  double size;  ///< N m, of the largest jump, at 180 and 540 degrees; 0: it has none
};

const double kPi = std::numbers::pi;

/// A measure h(phi) jumps by 2 h(pi); one that is a sine is smooth.
const Jump kJumps[] = {
    {"invariant", kZ, 2 * kPi},   {"attached_b", kZ, 2 * kPi},  {"havok", kZ, 2 * kPi},
    {"rapier_asin", kZ, 2 * kPi}, {"jolt_6dof", kZ, 4},         {"ode_fixed", kX, 4},
    {"conformal", kZ, 16},        {"physx_swing_twist", kX, 4}, {"physx_swing_twist", kZ, 0},
    {"physx_slerp", kZ, 0},       {"mujoco_weld", kZ, 0},       {"fasse", kZ, 0},
    {"quaternion", kZ, 0},        {"mbsim_offdiag", kZ, 0},     {"dart_free", kZ, 2 * kPi}};

std::vector<Finding> jump(const Jump& j, std::size_t number) {
  constexpr int kHalfDegrees = 1440;  // half a degree each, and half a step beside 180 degrees
  const auto answer = program_subject(j.joint);
  const auto at = [&](int i) {
    reference::Ask ask;
    ask.K_f = ask.K_m = Mat3<double>::Identity();
    ask.b.q = reference::quaternion_of((i + 0.5) * 4 * kPi / kHalfDegrees * j.axis);
    return V(part(answer(ask), 3));
  };
  double largest = 0, where = NAN;
  V before = at(0);
  for (int i = 1; i < kHalfDegrees; ++i) {
    const V now = at(i);
    const double size = (now - before).norm();
    if (!(size <= largest)) largest = size, where = double(i) * 720 / kHalfDegrees;
    before = now;
  }
  const double step = 4 * kPi / kHalfDegrees;
  Draft size = program_finding(fmt::format("jump/{}", number), j.joint)
                   .measured(largest, fmt::format("at {} degrees", where))
                   .in("N m");
  if (j.size == 0)
    return {size.at_most(step, "smooth: a step times a rate of one at most").by(Oracle::closed_form)};
  return {size.equal(j.size, 0.05 * j.size, "half a step before and after, by the rate of the measure there")
              .by(Oracle::closed_form),
          program_finding(fmt::format("jump_place/{}", number), j.joint)
              .measured(std::abs(std::fmod(where, 360) - 180))
              .in("degrees from a half turn")
              .at_most(0.5, "a step")
              .by(Oracle::closed_form)};
}

std::vector<Finding> jumps() {
  std::vector<Finding> out;
  for (std::size_t i = 0; i < std::size(kJumps); ++i)
    for (const Finding& f : jump(kJumps[i], i)) out.push_back(f);
  return out;
}

}  // namespace

void program_range(Checks& checks) {
  checks.push_back({"programs/turns", "", turns});
  checks.push_back({"programs/jumps", "", jumps});
}

}  // namespace halfway::verify
