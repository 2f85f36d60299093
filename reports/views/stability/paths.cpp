#include "reports/views/stability/paths.hpp"

#include "reference/solve/solve.hpp"
#include "verify/studies/paths/block_paths.hpp"

#include <array>

namespace halfway::reports {
namespace {

using nlohmann::json;
using reference::Continuation;
using reference::Entry;
using reference::EquilibriumPath;

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

json curve(const Entry& entry, const char* load, const Continuation& continuation, const std::string& branch,
           const EquilibriumPath& path) {
  return {{"formulation", entry.name},
          {"xi", entry.probe_xi},
          {"load", load},
          {"branch", branch},
          {"points", points(continuation, path)},
          {"events", events(path)},
          {"outcome", path.outcome},
          {"shortened", path.rejected},
          {"iterations", path.iterations}};
}

json step_row(const Entry& entry, const char* solver, int count, const reference::LoadSteps& steps,
              const reference::OffPath& off) {
  return {{"formulation", entry.name},
          {"xi", entry.probe_xi},
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
void add_formulation(json& out, const Entry& entry) {
  const auto& [continuation, path] = verify::skewed_path(entry);
  out["curves"].push_back(curve(entry, "skewed", continuation, "primary", path));
  for (int n : kSteps) {
    const verify::BlockSteps& steps = verify::load_steps(entry, n);
    out["steps"].push_back(step_row(entry, "Newton", n, steps.newton, steps.newton_off));
    out["steps"].push_back(step_row(entry, "GSL", n, steps.gsl, steps.gsl_off));
  }
  const auto& [on_axis, branches] = verify::straight_branches(entry);
  for (const auto& branch : branches)
    out["curves"].push_back(curve(entry, "straight", on_axis, branch.name, branch.path));
}

}  // namespace

json stability_paths_record() {
  json out = {
      {"scene", verify::kBlockPathScene},
      {"columns", {"factor", "theta_x", "theta_y", "theta_z", "phi", "sign", "negative", "eigenvalue"}},
      {"curves", json::array()},
      {"steps", json::array()}};
  for (const Entry& entry : reference::formulations()) {
    if (reference::accepts_law(entry, verify::straight_block().joint)) add_formulation(out, entry);
  }
  return out;
}

}  // namespace halfway::reports
