#include "reports/check/judge/causes.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::check {
namespace {

constexpr const char* kOwnAnchors =
    "Each body gets the force at its own anchor. The two anchors are d apart, so d x f is left over.";
constexpr const char* kOnePoint =
    "Both forces at one point, say b's anchor p_b: torque on a = -M + (p_b - x_a) x (-f), on b = M + (p_b - "
    "x_b) x f.";
constexpr const char* kShortened =
    "The moments act along the reciprocal axes of the Euler angles, each shortened to length one: virtual "
    "work asks for the "
    "axes divided by cos(e_2).";
constexpr const char* kReciprocal = "M = S^-T (k_i e_i), S the matrix of the three current axes: w = S de.";
constexpr const char* kQuarter =
    "The vector part of the quaternion, sin(phi/2) n, stands for the rotation vector, and its gradient, a "
    "half again, for "
    "the axes.";

constexpr Cause kCauses[] = {
    {"bullet_6dof", "level3/moment_balance", kOwnAnchors, kOnePoint},
    {"bullet_6dof", "level3/loop_one", kShortened, kReciprocal},
    {"bullet_6dof_at_b", "level3/loop_one", kShortened, kReciprocal},
    {"bullet_default", "level3/moment_balance", kOwnAnchors, kOnePoint},
    {"bullet_default", "level3/masses",
     "Each row asks for the velocity f dt/m and may push between 0 and f dt; rows that others help push "
     "less.",
     "The impulse f dt itself: a target that cannot be met and the limits f dt, as "
     "BT_6DOF_FLAGS_USE_INFINITE_ERROR has it."},
    {"chrono_body", "level3/moment_balance", kOwnAnchors, kOnePoint},
    {"newton_d6", "level3/moment_balance", kOwnAnchors, kOnePoint},
    {"newton_d6", "level3/loop_one", "The moments act along the gimbal axes and not along their reciprocals.",
     kReciprocal},
    {"ode_amotor", "level3/loop_one", kShortened, kReciprocal},
    {"physx_slerp", "level1/stiffness", kQuarter,
     "e = 2 vec(q) and rows that are its gradient: four times the stiffness."},
    {"mujoco_weld", "level1/stiffness", kQuarter, "torquescale 4 gives the stiffness asked for."},
    {"dart_free", "level3/loop_six",
     "The coordinates are (log R, P_a^T d), their forces are taken along the axes of b.",
     "F = P_a K P_a^T d: the axes in which the coordinates are."},
    {"mbsim_offdiag", "level3/loop_one", "Single entries of the matrix are angles of no common rotation.",
     "The vector of the skew part, (R - R^T)/2, and its conjugate moment."},
};

}  // namespace

const Cause* find_cause(std::string_view joint, std::string_view id) {
  const auto it =
      std::ranges::find_if(kCauses, [&](const Cause& c) { return c.joint == joint && c.id == id; });
  return it == std::end(kCauses) ? nullptr : &*it;
}

}  // namespace halfway::check
