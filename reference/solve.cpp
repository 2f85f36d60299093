#include "reference/solve.hpp"

#include "reference/path.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reference {
namespace {

std::string describe(const Outcome<double>& state) {
  switch (state.status) {
    case Status::converged: return "converged";
    case Status::singular_tangent:
      return fmt::format("stopped at load factor {:.6g}: the tangent is singular there", state.factor);
    default:
      return fmt::format("stopped at load factor {:.6g}: no smaller load step converges on this branch", state.factor);
  }
}

}  // namespace

Curve solve_scene(const Scene& scene, const Entry& entry, double xi) {
  Curve curve;
  curve.scene = scene.name;
  curve.formulation = entry.name;
  curve.xi = xi;
  curve.columns = {"factor"};
  curve.columns.insert(curve.columns.end(), scene.outputs.begin(), scene.outputs.end());

  Path<double> path(scene, entry, xi);
  const auto add_row = [&] {
    std::vector<double> row{path.state().factor};
    for (const std::string& output : scene.outputs) row.push_back(path.output(output));
    curve.rows.push_back(row);
  };
  add_row();
  for (int i = 1; i <= scene.points && path.state().status == Status::converged; ++i) {
    if (path.advance(scene.factor_end * i / scene.points).status == Status::converged) add_row();
  }
  curve.converged = path.state().status == Status::converged;
  curve.outcome = describe(path.state());
  curve.iterations = path.state().iterations;
  curve.residual = path.state().residual;
  return curve;
}

std::vector<Choice> choices(const Scene& scene) {
  std::vector<Choice> out;
  for (const Entry& entry : formulations()) {
    const bool wanted =
        scene.formulations.empty() || std::ranges::find(scene.formulations, entry.name) != scene.formulations.end();
    if (!wanted) continue;
    if (!entry.needs_xi) {
      out.push_back({&entry, entry.probe_xi});
    } else {
      for (double xi : scene.xis) out.push_back({&entry, xi});
    }
  }
  return out;
}

}  // namespace halfway::reference
