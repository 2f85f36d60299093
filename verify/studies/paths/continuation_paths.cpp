// The skewed buckling case by arc length: against load stepping, there and back, and in coarse
// steps; and what load stepping in whole steps makes of it.
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/solve.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/scene_access.hpp"
#include "verify/oracle/worst.hpp"
#include "verify/studies/paths/block_paths.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Continuation;
using reference::ContinuationOptions;
using reference::EquilibriumPath;

constexpr const char* kForceScene = "c6_compression_shear";
constexpr int kLoadSteps = 18;
constexpr double kSamePath = 1e-12;  // rad
constexpr double kAtPole = 1e-8;
constexpr const char* kWhy =
    "to rounding, amplified beside the branching a thousandfold (1e-12), and beside a pole by the tangent, "
    "which grows to 5e7 times that at rest before a path ends there (1e-8)";

double limit_of(const EquilibriumPath& path) {
  return path.end == reference::PathEnd::pole ? kAtPole : kSamePath;
}

Draft c3_finding(const Entry& entry, const char* what) {
  return property_finding(entry, Kind::angular, std::string("c3_") + what).in("rad").by(Oracle::independent);
}

/// Wherever load stepping gets, the path by arc length has been. NaN where it gets nowhere.
double off_load_steps(const reference::Scene& s, const Entry& entry, const Continuation& continuation,
                      const EquilibriumPath& path, double& reached) {
  Measurement worst;
  reference::Path<double> steps(s, entry, entry.probe_xi);
  for (int i = 1; i <= s.points; ++i) {
    const auto& state = steps.advance(s.factor_end * i / s.points);
    reached = state.factor;
    if (state.status != Status::converged) break;
    worst.include(distance_off_path(continuation, path, {state.joint, state.factor}), {});
  }
  return worst.value();
}

Finding against_load_steps(const Entry& entry, const Continuation& continuation,
                           const EquilibriumPath& path) {
  double reached = 0;
  const double off = off_load_steps(scene(kBlockPathScene), entry, continuation, path, reached);
  return c3_finding(entry, "arc_length")
      .measured(off, fmt::format("load steps to {:.6g} N m; by arc length: {}", reached, path.outcome))
      .at_most(limit_of(path), kWhy);
}

/// Six unknowns and a force thirty times that of the scene, so that the joint turns far.
std::vector<Finding> with_forces(const Entry& entry) {
  reference::Scene s = scene(kForceScene);
  s.factor_end *= 30;
  ContinuationOptions options;
  options.end_factor = s.factor_end;
  const Continuation continuation(s, entry, entry.probe_xi, options);
  const EquilibriumPath path = continuation.from_rest();
  double reached = 0;
  const double off = off_load_steps(s, entry, continuation, path, reached);
  return {property_finding(entry, s.joint.kind, "c6_arc_length")
              .measured(off, fmt::format("load steps to {:.6g} N; by arc length: {}", reached, path.outcome))
              .in("rad")
              .at_most(1e-14,
                       "both to rounding on a regular path; displacements over the length that makes "
                       "stiffnesses equal")
              .by(Oracle::independent)};
}

Finding there_and_back(const Entry& entry, const Continuation& continuation, const EquilibriumPath& path) {
  const auto& last = path.points.back();
  const EquilibriumPath back = continuation.from(last.state, -last.tangent);
  return c3_finding(entry, "reversal")
      .measured(back.end == reference::PathEnd::unloaded ? back.points.back().phi : std::nan(""),
                fmt::format("from {:.6g} N m, phi = {:.4f} rad", last.state.factor, last.phi))
      .at_most(1e-13, "back at the load factor 0 to the pose at rest, which is a regular point: rounding")
      .by(Oracle::closed_form);
}

/// NaN when the rough path ends otherwise than the fine one.
double off_fine_path(const Continuation& continuation, const EquilibriumPath& fine,
                     const EquilibriumPath& rough) {
  constexpr double kSameEnd = 1e-4;  // rad: a path that ends at pi or at a pole does so within this
  if (rough.end != fine.end || std::abs(rough.points.back().phi - fine.points.back().phi) > kSameEnd)
    return std::nan("");
  Measurement worst;
  for (const auto& p : rough.points) {
    const double distance = distance_off_path(continuation, fine, p.state);
    const bool is_beyond = !(distance == distance) && p.state.b.R.allFinite();  // the other's last point
    if (!is_beyond) worst.include(distance, {});
  }
  return worst.value();
}

/// Steps that may bend and correct as they like: only the signs are left to tell a jump.
ContinuationOptions by_signs_alone(ContinuationOptions options) {
  options.largest_angle = 3.2;
  options.largest_correction = options.largest_contraction = 10;
  return options;
}

/// First steps as long as those of load stepping where it jumps: no jump, whatever the first guess.
Finding coarse(const Entry& entry, const Continuation& continuation, const EquilibriumPath& path,
               bool all_guards) {
  Measurement worst;
  std::string where;
  for (int steps : {4, 6, 10, 15, 18}) {
    ContinuationOptions options = whole_load();
    options.first_step = options.largest_step = path.points.back().arc / steps;
    if (!all_guards) options = by_signs_alone(options);
    const EquilibriumPath rough =
        Continuation(scene(kBlockPathScene), entry, entry.probe_xi, options).from_rest();
    worst.include(off_fine_path(continuation, path, rough), {});
    where += fmt::format("{} steps asked for, {} taken, {} shortened; ", steps, rough.points.size() - 1,
                         rough.rejected);
  }
  return c3_finding(entry, all_guards ? "coarse_steps" : "coarse_steps_by_signs")
      .measured(worst.value(), where + path.outcome)
      .at_most(limit_of(path), kWhy);
}

std::vector<Finding> skewed(const Entry& entry) {
  if (const double radius = convex_radius(entry, scene(kBlockPathScene).joint); std::isfinite(radius))
    return {c3_finding(entry, "arc_length")
                .left_out(
                    fmt::format("refused beyond {:.3g} rad, where its energy ceases to be convex", radius))};
  const auto& [continuation, path] = skewed_path(entry);
  return {against_load_steps(entry, continuation, path), there_and_back(entry, continuation, path),
          coarse(entry, continuation, path, true), coarse(entry, continuation, path, false)};
}

/// Load stepping in 18 steps: which states are not on the path, per formulation and solver.
std::vector<Finding> eighteen_steps() {
  std::vector<Finding> out;
  for (const Entry& entry : reference::formulations()) {
    const auto add = [&](const char* solver, const reference::LoadSteps& steps,
                         const reference::OffPath& off) {
      const bool is_anywhere = skewed_path(entry).path.points.size() > 1 && steps.states.size() > 1;
      const std::string end_at = fmt::format(
          "{} {:.6g} N m", steps.converged ? "converged to" : "gave up after", steps.states.back().factor);
      const std::string first =
          off.count > 0 ? fmt::format("; the first at {:.6g} N m", off.first_factor) : "";
      out.push_back(c3_finding(entry, solver)
                        .measured(is_anywhere ? off.count : std::nan(""), end_at + first)
                        .in("states")
                        .reported("states of 18 load steps that lie elsewhere than on the path"));
    };
    const BlockSteps& steps = load_steps(entry, kLoadSteps);
    add("load_steps_newton", steps.newton, steps.newton_off);
    add("load_steps_gsl", steps.gsl, steps.gsl_off);
  }
  return out;
}

}  // namespace

void continuation_paths(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    checks.push_back(
        {property_name(entry, Kind::angular, "c3_path"), "stability", [&entry] { return skewed(entry); }});
  }
  for (const Entry& entry : reference::formulations()) {
    if (!accepts_law(entry, scene(kForceScene).joint)) continue;
    checks.push_back({property_name(entry, scene(kForceScene).joint.kind, "c6_path"), "stability",
                      [&entry] { return with_forces(entry); }});
  }
  checks.push_back({"continuation/eighteen_steps", "stability", eighteen_steps});
}

}  // namespace halfway::verify
