#include "reports/views/stability_paths.hpp"

#include "reference/solve/paths/branches.hpp"
#include "reference/solve/paths/continuation_load_steps.hpp"
#include "reference/solve/solve.hpp"
#include "verify/oracle/scene_access.hpp"

#include <array>

namespace halfway::reports {
namespace {

using nlohmann::json;
using reference::Continuation;
using reference::EquilibriumPath;

constexpr const char* kScene = "c3_buckling";
constexpr std::array<int, 6> kSteps = {6,  10, 15,
                                       18, 36, 180};  // of the load: few enough to jump, and enough

json points(const Continuation& continuation, const EquilibriumPath& path) {
  json out = json::array();
  for (const auto& p : path.points) {
    json row = {p.state.factor};
    for (const char* name : {"theta_x", "theta_y", "theta_z"})
      row.push_back(continuation.problem().output(name, p.state.b));
    for (double x : {p.phi, double(p.stiffness_sign), double(p.negative), p.eigenvalue}) row.push_back(x);
    out.push_back(std::move(row));
  }
  return out;
}

json events(const EquilibriumPath& path) {
  json out = json::array();
  for (const auto& s : path.singular) {
    out.push_back({{"type", to_string(s.type)},
                   {"factor", s.state.factor},
                   {"phi", s.phi},
                   {"located_to", s.located_to},
                   {"simple", s.simple}});
  }
  return out;
}

json curve(const reference::Choice& choice, const char* load, const Continuation& continuation,
           const reference::Branch& branch) {
  return {{"formulation", choice.entry->name},
          {"xi", choice.xi},
          {"load", load},
          {"branch", branch.name},
          {"points", points(continuation, branch.path)},
          {"events", events(branch.path)},
          {"outcome", branch.path.outcome},
          {"shortened", branch.path.rejected},
          {"iterations", branch.path.iterations}};
}

json step_row(const reference::Choice& choice, const char* solver, const Continuation& continuation,
              const EquilibriumPath& path, int count, const reference::LoadSteps& steps) {
  const reference::OffPath off = off_path(continuation, path, steps);
  return {{"formulation", choice.entry->name},
          {"xi", choice.xi},
          {"solver", solver},
          {"steps", count},
          {"converged", steps.converged},
          {"reached", steps.states.back().factor},
          {"off", off.count},
          {"first_off", off.first_factor},
          {"distance_off", off.largest_distance},
          {"message", steps.message}};
}

/// All that is shown of one formulation.
void add_formulation(json& out, const reference::Scene& skewed, const reference::Scene& straight,
                     const reference::Choice& choice) {
  reference::ContinuationOptions options;
  options.end_factor = skewed.factor_end;
  const Continuation continuation(skewed, *choice.entry, choice.xi, options);
  const EquilibriumPath path = continuation.from_rest();
  out["curves"].push_back(curve(choice, "skewed", continuation, {"primary", path}));
  const double end = skewed.factor_end;
  for (int n : kSteps) {
    const auto& problem = continuation.problem();
    out["steps"].push_back(
        step_row(choice, "Newton", continuation, path, n, newton_load_steps(problem, end, n)));
    out["steps"].push_back(step_row(choice, "GSL", continuation, path, n, gsl_load_steps(problem, end, n)));
  }
  const Continuation on_axis(straight, *choice.entry, choice.xi, options);
  for (const reference::Branch& branch : branches(on_axis))
    out["curves"].push_back(curve(choice, "straight", on_axis, branch));
}

}  // namespace

json stability_paths_record() {
  const reference::Scene& skewed = verify::scene(kScene);
  const reference::Scene straight = reference::without_skew(skewed, skewed.critical_axis - 1);
  json out = {
      {"scene", kScene},
      {"columns", {"factor", "theta_x", "theta_y", "theta_z", "phi", "sign", "negative", "eigenvalue"}},
      {"curves", json::array()},
      {"steps", json::array()}};
  for (const reference::Entry& entry : reference::formulations()) {
    if (reference::accepts_law(entry, skewed.joint))
      add_formulation(out, skewed, straight, {&entry, entry.probe_xi});
  }
  return out;
}

}  // namespace halfway::reports
