// Where plain load stepping stops, does it name the cause that the path by arc length has found there?
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/paths/continuation.hpp"
#include "reference/solve/solve.hpp"
#include "reference/solve/stop_cause.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"

#include <fmt/format.h>

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

/// The scene above, and the canonical ones in which paths end.
std::vector<Finding> all_named(const Entry& entry) {
  std::vector<Finding> out = {named(entry, overloaded(), "cause")};
  for (const char* name : {"c1_extended", "c3_buckling"}) out.push_back(named(entry, scene(name), name));
  return out;
}

}  // namespace

void stops(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    checks.push_back({fmt::format("{}/stops", entry.name), "scenes", [&entry] { return all_named(entry); }});
  }
}

}  // namespace halfway::verify
