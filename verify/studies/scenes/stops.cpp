// Where plain load stepping stops, does it name the cause that the path by arc length has found there?
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/paths/continuation.hpp"
#include "reference/solve/solve.hpp"
#include "reference/solve/stop_cause.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::PathEnd;
using reference::Scene;
using reference::StopCause;

/// A skew moment that no law but a stiffening one carries to the end.
Scene overloaded() {
  Scene scene;
  scene.name = "overloaded";
  const Eigen::MatrixXd K = Vec3<double>(1, 2, 3).asDiagonal();
  scene.joint.law = reference::LinearSpec{K, false};
  scene.joint.a.H = so3::exp<double>({0.3, -0.8, 0.5});
  scene.joint.b.H = so3::exp<double>({-0.6, 0.2, 1.1});
  scene.loads = {{reference::LoadType::fixed_moment, {1, 0.5, 0.3}}};
  scene.outputs = {"theta_x"};
  scene.factor_end = 50;
  scene.points = 10;
  return scene;
}

/// Does the strain of the law change by more than a radian within a thousandth of one?
bool strain_jumps(const Scene& scene, const Entry& entry, double factor) {
  reference::Path<double> path(scene, entry, entry.probe_xi);
  const Outcome<double> state = path.advance(factor);
  const Motion<double> slope = state.last.slope;
  const Pose<double> ahead{{}, so3::exp<double>(1e-3 * slope.tail<3>().normalized()) * state.joint.R};
  reference::JointSpec spec = scene.joint;
  spec.a = spec.b = {};
  const auto strain = [&](const Pose<double>& b) { return entry.in_double.strain(spec, {}, b); };
  return (strain(ahead) - strain(state.joint)).norm() > 1;
}

/// What lies at the load factor where load stepping stopped.
StopCause by_arc(const Scene& scene, const Entry& entry, double stopped_at) {
  constexpr double kSamePlace =
      1e-4;  // relative: load steps shrink to 1e-9 of an advance, a fold to its root
  reference::ContinuationOptions options;
  options.end_factor = scene.factor_end;
  const reference::Continuation continuation(scene, entry, entry.probe_xi, options);
  const reference::EquilibriumPath path = continuation.from_rest();
  const auto is_here = [&](double factor) {
    return std::abs(factor - stopped_at) <= kSamePlace * stopped_at;
  };
  for (const auto& s : path.singular) {
    if (!is_here(s.state.factor)) continue;
    return s.type == reference::Singularity::fold ? StopCause::fold : StopCause::branching;
  }
  const bool ends_here = is_here(path.points.back().state.factor);
  if (ends_here && path.end == PathEnd::half_turn) return StopCause::half_turn;
  if (ends_here && path.end == PathEnd::pole) return StopCause::pole;
  // Euler angles go on beyond phi = pi, where the path by arc length ends; their own jump is in the strain.
  if (path.end == PathEnd::half_turn && path.points.back().state.factor < stopped_at &&
      strain_jumps(scene, entry, stopped_at))
    return StopCause::jump;
  return StopCause::unknown;
}

/// Does a curve end where the next point leaves the convex range, and every one of its own is inside?
bool ends_at_convexity(const Scene& scene, const Entry& entry, const reference::Curve& curve) {
  const double radius = reference::convex_radius(entry, scene.joint);
  reference::Path<double> path(scene, entry, entry.probe_xi);
  const auto turned_at = [&](double factor) { return so3::log<double>(path.advance(factor).joint.R).norm(); };
  for (const auto& row : curve.rows)
    if (!(turned_at(row.front()) <= radius)) return false;
  return turned_at(curve.rows.back().front() + scene.factor_end / scene.points) > radius;
}

Finding named(const Entry& entry, const Scene& scene, const std::string& what) {
  const reference::Curve curve = reference::solve_scene(scene, {&entry, entry.probe_xi});
  double missed = 0;
  std::string told = curve.outcome;
  if (curve.outcome.find("convex") != std::string::npos) {
    missed = !ends_at_convexity(scene, entry, curve);
  } else if (!curve.converged) {
    const StopCause cause = by_arc(scene, entry, curve.rows.back().front());
    missed = cause == StopCause::unknown || curve.outcome.find(to_string(cause)) == std::string::npos;
    told += fmt::format("; by arc length: {}", to_string(cause));
  }
  return finding(fmt::format("{}/stops/{}", entry.name, what))
      .of(std::string(entry.name))
      .about("stops")
      .measured(missed, told)
      .in("causes not named")
      .at_most(0, "the outcome names what the path by arc length meets at the same load factor")
      .by(Oracle::independent);
}

/// Where the path ends that load steps follow, asked for so many points.
Outcome<double> end_of(const Scene& scene, const Entry& entry, int points,
                       const SolverOptions<double>& options = {}) {
  const reference::EquilibriumProblem<double> problem(scene, entry, entry.probe_xi);
  Outcome<double> at = problem.initial();
  for (int i = 1; i <= points && is_equilibrium(at.status); ++i)
    at = problem.follow_to(at, scene.factor_end * i / points, options);
  return at;
}

/// Of the path by arc length; NaN where it does not fold.
double first_fold(const Scene& scene, const Entry& entry) {
  reference::ContinuationOptions options;
  options.end_factor = scene.factor_end;
  for (const auto& s : reference::Continuation(scene, entry, entry.probe_xi, options).from_rest().singular)
    if (s.type == reference::Singularity::fold) return s.state.factor;
  return std::nan("");
}

constexpr std::array kPointCounts{1, 7, 30, 144};

/// How many of the ways by so many points end elsewhere than the path by arc length folds, or, where it does
/// not fold, than the way by twice as many does.
int elsewhere(const Scene& scene, const Entry& entry, const SolverOptions<double>& options = {}) {
  constexpr double kSame = 1e-4;  // relative: load steps shrink to 1e-9 of an advance, a fold to its root
  const double fold = first_fold(scene, entry);
  const Outcome<double> finest = end_of(scene, entry, 2 * kPointCounts.back());
  const double place = std::isnan(fold) ? finest.factor : fold;
  int out = !(finest.factor > 0 && std::abs(finest.factor - place) <= kSame * place);
  for (const int points : kPointCounts) {
    const Outcome<double> end = end_of(scene, entry, points, options);
    // The last steps before a fold are short in the load and long in the state.
    const double turn = so3::log<double>(end.joint.R * finest.joint.R.transpose()).norm();
    out += !(std::abs(end.factor - place) <= kSame * place && turn <= std::sqrt(kSame));
  }
  return out;
}

Finding of_any_steps(const Entry& entry, const std::string& name) {
  return finding(fmt::format("{}/stops/{}/points", entry.name, name))
      .of(std::string(entry.name))
      .about("stops")
      .measured(elsewhere(scene(name), entry))
      .in("ways that end elsewhere")
      .at_most(0, "a path has one end, however many points of it are asked for")
      .by(Oracle::independent);
}

/// The scene above, and the canonical ones in which paths end.
std::vector<Finding> all_named(const Entry& entry) {
  std::vector<Finding> out = {named(entry, overloaded(), "cause")};
  for (const char* name : {"c1_extended", "c3_buckling"}) {
    out.push_back(named(entry, scene(name), name));
    out.push_back(of_any_steps(entry, name));
  }
  return out;
}

/// Load steps that take whatever is within 0.35 rad jump over the fold of `jointc`. Says nothing where
/// guarded ones are not right.
std::vector<Finding> long_steps() {
  const Scene& folds = scene("c3_buckling");
  const Entry& entry = *reference::find_formulation("jointc");
  SolverOptions<double> trusting;
  trusting.crossing = trusting.largest_turn;
  return {finding("stops/long_steps/told")
              .about("stops")
              .measured(elsewhere(folds, entry) == 0 ? elsewhere(folds, entry, trusting) : std::nan(""))
              .in("ways that end elsewhere")
              .at_least(1, "a solver without the two guards of branches must be told apart")
              .by(Oracle::independent)};
}

}  // namespace

void stops(Checks& checks) {
  checks.push_back({"stops/long_steps", "scenes", long_steps});
  for (const Entry& entry : reference::formulations()) {
    checks.push_back({fmt::format("{}/stops", entry.name), "scenes", [&entry] { return all_named(entry); }});
  }
}

}  // namespace halfway::verify
