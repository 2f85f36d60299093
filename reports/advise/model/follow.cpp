#include "reference/face/kernel_variants.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/solve/free_directions.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/stop_cause.hpp"
#include "reports/advise/model/candidate.hpp"

#include <algorithm>

namespace halfway::advise {
namespace {

using reference::Entry, reference::Path, reference::Scene;

/// What is timed: the kernel with its cheaper angle or in float. A kernel in double is its transcription to
/// rounding (the benchmark's check), which any law can be asked of.
Entry evaluated(const Candidate& c) {
  if (c.precision == "float") return reference::with_kernel(*c.entry, true);
  for (const auto& known : reference::invariant_variants()) {
    if (!c.variant.empty() && known.name == c.variant) return reference::with_variant(*c.entry, known);
  }
  return *c.entry;
}

/// The outputs of `scene` where the model has them, 0 where its kind has none of that sort.
std::vector<double> row_of(const Scene& scene, const std::vector<std::string>& has, const auto& value) {
  std::vector<double> out;
  for (const std::string& output : scene.outputs)
    out.push_back(std::ranges::find(has, output) == has.end() ? 0 : value(output));
  return out;
}

void follow_linear(const Scene& scene, const Scene& own, Answers& out) {
  const Path<double> path(own, reference::formulations().front(), 0.5);
  for (const double factor : out.factor)
    out.value.push_back(row_of(
        scene, own.outputs, [&](const std::string& output) { return path.linear_output(output, factor); }));
}

/// Where loads in float put the equilibrium next to that of double: one step of Newton with them.
Pose<double> in_float(const reference::EquilibriumProblem<double>& single, const Pose<double>& joint,
                      double factor) {
  const auto balance = single.balance(joint, factor);
  return single.displaced(joint, reference::lu_solve(balance.tangent, balance.imbalance));
}

void follow_path(const Scene& scene, const Scene& own, const Candidate& c, bool exchanged, Answers& out) {
  const Entry entry = evaluated(c);
  const bool single = c.precision == "float";
  const reference::Setting setting{exchanged};
  const double xi = exchanged ? 1 - c.xi : c.xi;
  Path<double> path(own, single ? *c.entry : entry, xi, setting);
  const reference::EquilibriumProblem<double> rounded(own, entry, xi, setting);
  const double radius = reference::convex_radius(*c.entry, own.joint);
  for (const double factor : out.factor) {
    const auto& state = path.advance(factor);
    if (!is_equilibrium(state.status)) {
      out.ended = to_string(reference::stop_cause(path.problem(), state));
      return;
    }
    if (const double phi = so3::log(state.joint.R).norm(); phi > radius) {
      out.ended = reference::beyond_convexity(phi, radius);
      return;
    }
    const Pose<double> joint = single ? in_float(rounded, state.joint, factor) : state.joint;
    out.value.push_back(
        row_of(scene, own.outputs, [&](const std::string& output) { return rounded.output(output, joint); }));
    out.node.push_back(rounded.node(joint));
  }
}

}  // namespace

Answers follow(const Scene& scene, const Candidate& candidate, const std::vector<double>& factors,
               bool exchanged) {
  Answers out{scene.outputs, factors, {}};
  Scene own = candidate.kind == scene.joint.kind ? scene : *as_kind(scene, candidate.kind);
  // Directions without stiffness are held: no load works there (asked before), so that it makes no
  // difference.
  if (const auto held = reference::held(own, 1)) own = *held;
  if (candidate.entry)
    follow_path(scene, own, candidate, exchanged, out);
  else
    follow_linear(scene, own, out);
  return out;
}

}  // namespace halfway::advise
