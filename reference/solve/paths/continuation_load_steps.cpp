#include "reference/solve/paths/continuation_load_steps.hpp"

#include "reference/solve/gsl_solver.hpp"

#include <cmath>
#include <functional>
#include <optional>

namespace halfway::reference {
namespace {

using Solve = std::function<std::optional<Pose<double>>(const ArcState<double>& start, std::string& message)>;

LoadSteps stepped(const EquilibriumProblem<double>& problem, double end_factor, int steps,
                  const Solve& solve) {
  LoadSteps out;
  out.states.push_back({problem.initial().joint, 0});
  for (int i = 1; i <= steps; ++i) {
    const ArcState<double> start{out.states.back().b, end_factor * i / steps};
    const auto found = solve(start, out.message);
    if (!found) return out;
    out.states.push_back({*found, start.factor});
  }
  out.converged = true;
  return out;
}

/// A problem at one load factor, with no guard: a system of Newton's method.
struct AtFactor {
  AtFactor(const EquilibriumProblem<double>& of, const ArcState<double>& start)
      : problem(of), joint(start.b), factor(start.factor) {}

  NewtonLook<double> look() {
    const NodeBalance<double> at = problem.balance(joint, factor);
    correction = lu_solve(at.tangent, at.imbalance);
    return {correction.norm(), (at.imbalance.cwiseAbs().array() <= at.rounding.array()).all()};
  }
  void move() { joint = problem.displaced(joint, correction); }

  const EquilibriumProblem<double>& problem;
  Pose<double> joint;
  double factor;
  NodeVector<double> correction;
};

}  // namespace

LoadSteps newton_load_steps(const EquilibriumProblem<double>& problem, double end_factor, int steps) {
  constexpr int kCorrections = 50;
  return stepped(problem, end_factor, steps,
                 [&](const ArcState<double>& start, std::string& message) -> std::optional<Pose<double>> {
                   AtFactor system(problem, start);
                   const auto run = newton<double>(system, kCorrections, kCorrections);
                   if (run.stop == NewtonStop::rounding) return system.joint;
                   message = "no convergence in 50 iterations";
                   return std::nullopt;
                 });
}

LoadSteps gsl_load_steps(const EquilibriumProblem<double>& problem, double end_factor, int steps) {
  constexpr double kTolerance =
      1e-10;  // of the imbalance over the load: the finite differences allow no less
  return stepped(problem, end_factor, steps,
                 [&](const ArcState<double>& start, std::string& message) -> std::optional<Pose<double>> {
                   const double load = problem.balance(start.b, start.factor).by_factor.norm() * start.factor;
                   const auto residual = [&](const Eigen::VectorXd& x) -> Eigen::VectorXd {
                     return problem.balance(problem.displaced(start.b, x), start.factor).imbalance / load;
                   };
                   const GslOutcome found =
                       gsl_hybrids(residual, Eigen::VectorXd::Zero(problem.unknowns()), kTolerance);
                   message = found.message;
                   if (!found.converged) return std::nullopt;
                   return problem.displaced(start.b, found.x);
                 });
}

double distance_off_path(const Continuation& continuation, const EquilibriumPath& path,
                         const ArcState<double>& state) {
  double nearest = std::nan("");
  for (const ArcState<double>& on_path : continuation.at_factor(path, state.factor)) {
    const double distance = continuation.distance(on_path, state);
    if (!(nearest <= distance)) nearest = distance;
  }
  return nearest;
}

OffPath off_path(const Continuation& continuation, const EquilibriumPath& path, const LoadSteps& steps) {
  constexpr double kOnPath = 1e-6;  // rad: GSL's finite differences leave 1e-8, another path is far away
  OffPath out;
  for (const ArcState<double>& state : steps.states) {
    const double distance = distance_off_path(continuation, path, state);
    if (distance <= kOnPath) continue;
    if (out.count++ == 0) out.first_factor = state.factor;
    if (distance > out.largest_distance) out.largest_distance = distance;
  }
  return out;
}

}  // namespace halfway::reference
