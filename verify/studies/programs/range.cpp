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

}  // namespace

void program_range(Checks& checks) { checks.push_back({"programs/turns", "", turns}); }

}  // namespace halfway::verify
