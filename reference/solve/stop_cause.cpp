#include "reference/solve/stop_cause.hpp"

#include <cmath>
#include <numbers>

namespace halfway::reference {

namespace {

/// What the tangent does not foretell of the loads a step ahead on the path; the step in rad, or m.
double unforetold(const EquilibriumProblem<double>& problem, const Outcome<double>& state,
                  const NodeBalance<double>& here, const NodeVector<double>& slope, double ahead) {
  const NodeVector<double> step = slope * (ahead / slope.norm());
  const NodeVector<double> foretold = here.imbalance - here.tangent * step;
  return (problem.balance(problem.displaced(state.joint, step), state.factor).imbalance - foretold).norm();
}

/// Loads that jump are off by as much after a short step as after a long one; those of a curved path, however
/// soft the tangent is, by a hundredth after a tenth.
bool jumps_ahead(const EquilibriumProblem<double>& problem, const Outcome<double>& state,
                 const NodeBalance<double>& here, const NodeVector<double>& slope) {
  constexpr double kLong = 1e-3, kShort = 1e-4, kSame = 0.3;
  return unforetold(problem, state, here, slope, kShort) >
         kSame * unforetold(problem, state, here, slope, kLong);
}

}  // namespace

StopCause stop_cause(const EquilibriumProblem<double>& problem, const Outcome<double>& state) {
  // Load steps shrink to 1e-9 of an advance: 3e-5 of a turn before a fold, where the softest stiffness is
  // 1e-4.
  constexpr double kNearHalfTurn = 1e-3, kGrown = 1e3, kSoft = 1e-2;
  if (so3::log<double>(state.joint.R).norm() > std::numbers::pi - kNearHalfTurn) return StopCause::half_turn;
  const NodeBalance<double> rest = problem.balance(problem.start(), 0);
  const NodeBalance<double> here = problem.balance(state.joint, state.factor);
  // Over the stiffness at rest, so that no unit and no ratio of stiffnesses counts.
  const NodeMatrix<double> grown = lu_solve(rest.tangent, here.tangent);
  if (!(grown.norm() <= kGrown)) return StopCause::pole;
  const NodeVector<double> slope = lu_solve(here.tangent, here.by_factor);
  if (jumps_ahead(problem, state, here, slope)) return StopCause::jump;
  const double softest = 1 / lu_inverse(grown).norm();
  if (!(softest <= kSoft)) return StopCause::unknown;
  const NodeVector<double> response = lu_solve(rest.tangent, rest.by_factor);
  return slope.norm() * std::sqrt(softest) > response.norm() ? StopCause::fold : StopCause::branching;
}

const char* to_string(StopCause cause) {
  switch (cause) {
    case StopCause::half_turn:
      return "half a turn: phi reaches pi, where rotation vectors jump";
    case StopCause::jump:
      return "an angle of the law reaches pi and jumps";
    case StopCause::pole:
      return "the loads grow without bound: a pole of the formulation, gimbal lock";
    case StopCause::fold:
      return "a fold: this path carries no more load";
    case StopCause::branching:
      return "a branching: the tangent is singular there";
    default:
      return "no smaller load step converges on this branch";
  }
}

}  // namespace halfway::reference
