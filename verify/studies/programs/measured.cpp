// Real programs, run: our law at their poses.
#include "reference/programs/measured.hpp"
#include "verify/studies/programs/subject.hpp"

namespace halfway::verify {
namespace {

/// A kept file, the law that it is held against, and what the program's answers are good for.
struct Case {
  const char* file;
  const char* law;
  double accuracy;
  const char* why;
};

constexpr const char* kDouble = "double precision, read without a time step";
constexpr const char* kStep = "double precision; loads are momenta over one time step from rest";
constexpr const char* kSingle = "single precision; loads are momenta over one time step from rest";

constexpr Case kCases[] = {
    {"mujoco_chain", "simbody_xyz", 1e-12, kDouble},
    {"mujoco_ball", "attached_a", 1e-13, kDouble},
    {"mujoco_weld", "mujoco_weld", 1e-10, "double precision; three impedances extrapolated to none"},
    {"mujoco_free", "mujoco_free", 1e-13, kDouble},
    {"bullet_old", "bullet_6dof", 1e-13, kStep},
    {"bullet_old_nooffset", "bullet_6dof_at_b", 1e-13, kStep},
    {"bullet", "bullet_6dof", 1e-13, kStep},
    {"bullet_default", "bullet_default", 1e-12, kStep},
    {"dart_ball", "attached_b", 1e-13, kDouble},
    {"dart_free", "dart_free", 1e-13, kDouble},
    {"ode_amotor", "ode_amotor", 1e-9, "double precision; two time steps extrapolated"},
    {"ode_fixed", "ode_fixed", 1e-9, "double precision; two time steps extrapolated"},
    {"physx_swing_twist", "physx_swing_twist", 1e-5, kSingle},
    {"physx_slerp", "physx_slerp", 1e-5, kSingle},
    {"jolt", "jolt_6dof", 5e-6, kSingle},
    {"jolt_partial", "jolt_partial", 1e-5, kSingle},
    {"rapier", "rapier_asin", 5e-6, kSingle},
    {"havok", "havok", 2e-5, "single precision, closed source: the law was found from these poses"},
    {"yade", "yade_line", 1e-12, kDouble},
};

Finding held(const Case& c, const char* digits, const Measurement& worst) {
  return program_finding(fmt::format("measured/{}", digits), c.file)
      .of(c.law)
      .measured(worst)
      .in("relative")
      .at_most(c.accuracy, c.why)
      .by(Oracle::other_program, c.accuracy);
}

std::vector<Finding> compared(const Case& c) {
  const auto program = reference::read_measured(c.file);
  const auto answer = program_subject(c.law);
  const auto* deep = reference::find_program_joint(c.law);
  Measurement in_double, at_50_digits;
  for (const auto& pose : program.poses) {
    const std::string at = fmt::format("pose {}", pose.id);
    in_double.include(reference::apart(pose.loads, answer(pose.ask)), at);
    if (deep) at_50_digits.include(reference::apart(pose.loads, tapped(deep->at_50_digits(pose.ask))), at);
  }
  std::vector<Finding> out{held(c, "double", in_double)};
  if (deep) out.push_back(held(c, "50_digits", at_50_digits));
  return out;
}

}  // namespace

void program_measured(Checks& checks) {
  for (const Case& c : kCases) {
    checks.push_back({fmt::format("programs/measured/{}", c.file), "", [&c] { return compared(c); }});
  }
}

}  // namespace halfway::verify
