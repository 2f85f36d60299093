#include "reference/solve/paths/arc_curve.hpp"

#include "reference/solve/paths/continuation.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/scene/joint/free_strains.hpp"

#include <fmt/format.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

/// What was met on the way: "; fold at load factor 258.7".
std::string singular_points(const EquilibriumPath& path) {
  std::string out;
  for (const SingularPoint& s : path.singular)
    out += fmt::format("; {} at load factor {:.10g}", to_string(s.type), s.state.factor);
  return out;
}

/// |internal - applied| over the load at the last point.
double residual(const EquilibriumProblem<double>& problem, const ArcState<double>& state) {
  const auto balance = problem.balance(state.b, state.factor);
  const double load = balance.by_factor.norm() * std::abs(state.factor);
  return balance.imbalance.norm() / (load > 0 ? load : 1);
}

/// Largest of the outputs at the point's load factor, rad or m, as the solver of load steps has it; without a
/// bound at a fold, where the factor turns.
double error_of(const EquilibriumProblem<double>& problem, const ArcState<double>& point,
                const Scene& scene) {
  const NodeBalance<double> balance = problem.balance(point.b, point.factor);
  const NodeVector<double> error =
      lu_inverse(balance.tangent).cwiseAbs() * balance.imbalance.cwiseAbs().cwiseMax(balance.rounding);
  Outcome<double> state;
  state.joint = point.b;
  if (problem.kind() != Kind::linear) state.error.tail<3>() = error.tail<3>();
  if (problem.kind() != Kind::angular) state.error.head<3>() = error.head<3>();
  double largest = 0;
  for (const std::string& output : scene.outputs) keep_largest(largest, problem.output_error(output, state));
  return largest;
}

/// Of a path that ends where it looks as if it changed to another one: a corner of the law's curves, or "".
std::string corner_at_end(const EquilibriumPath& path, const Continuation& continuation, const Scene& scene,
                          const Choice& choice) {
  const bool may_be = path.end == PathEnd::jump_not_excluded || path.end == PathEnd::no_convergence;
  if (!may_be || path.points.empty()) return "";
  JointSpec spec = scene.joint;
  spec.xi = choice.xi;
  const Eigen::VectorXd strain =
      choice.entry->in_double.strain(spec, {}, continuation.problem().node(path.points.back().state.b));
  const auto corner = corner_near(spec.law, strain);
  if (!corner) return "";
  return fmt::format(
      "the stiffness jumps: the curve of the {} has a corner at {:.6g}, and a path by arc length is "
      "smooth; load steps, without --arc, go on",
      strain_name(Eigen::VectorXd::Unit(strain.size(), corner->strain), spec.kind), corner->at);
}

}  // namespace

Curve follow_by_arc(const Scene& scene, const Choice& choice) {
  // A straight line has no folds, and a point no length.
  const auto grows = [](const SceneLoad& load) { return !load.held && !load.value.isZero(0); };
  if (!choice.entry || std::ranges::none_of(scene.loads, grows)) return solve_scene(scene, choice);
  ContinuationOptions options;
  options.end_factor = scene.factor_end;
  const Continuation continuation(scene, *choice.entry, choice.xi, options);
  const EquilibriumPath path = continuation.from_rest();
  Curve curve = empty_curve(scene, choice);
  const double radius = convex_radius(*choice.entry, scene.joint);
  curve.converged = path.end == PathEnd::end_factor;
  curve.outcome = (curve.converged ? "converged" : path.outcome) + singular_points(path);
  if (!curve.converged) curve.cause = to_string(path.end) + singular_points(path);
  if (const std::string corner = corner_at_end(path, continuation, scene, choice); !corner.empty()) {
    curve.cause = corner;
    curve.outcome = fmt::format("stopped at load factor {:.6g}: {}", path.points.back().state.factor, corner);
  }
  curve.iterations = path.iterations;
  if (!path.points.empty()) curve.residual = residual(continuation.problem(), path.points.back().state);
  for (const PathPoint& point : path.points) {
    if (const double phi = so3::log(point.state.b.R).norm(); phi > radius) {
      curve.converged = false;
      curve.cause = beyond_convexity(phi, radius);
      curve.outcome = fmt::format("stopped before load factor {:.6g}: {}", point.state.factor,
                                  beyond_convexity(*choice.entry, phi, radius));
      break;
    }
    std::vector<double> row{point.state.factor};
    for (const std::string& output : scene.outputs)
      row.push_back(continuation.problem().output(output, point.state.b));
    curve.rows.push_back(std::move(row));
    curve.errors.push_back(error_of(continuation.problem(), point.state, scene));
    curve.poses.push_back({continuation.problem().node(point.state.b)});
  }
  return curve;
}

}  // namespace halfway::reference
