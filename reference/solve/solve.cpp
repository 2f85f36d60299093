#include "reference/solve/solve.hpp"

#include "reference/solve/path.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reference {
namespace {

std::string describe(const Outcome<double>& state) {
  switch (state.status) {
    case Status::converged:
      return "converged";
    case Status::singular_tangent:
      return fmt::format("stopped at load factor {:.6g}: the tangent is singular there", state.factor);
    default:
      return fmt::format("stopped at load factor {:.6g}: no smaller load step converges on this branch",
                         state.factor);
  }
}

template <class Value>
std::vector<double> row_of(const Scene& scene, double factor, const Value& value) {
  std::vector<double> row{factor};
  for (const std::string& output : scene.outputs) row.push_back(value(output));
  return row;
}

void follow_path(const Scene& scene, const Entry& entry, const Told& told, Curve& curve) {
  Path<double> path(scene, entry, curve.xi);
  const auto add_row = [&] {
    curve.rows.push_back(
        row_of(scene, path.state().factor, [&](const std::string& output) { return path.output(output); }));
  };
  add_row();
  for (int i = 1; i <= scene.points && path.state().status == Status::converged; ++i) {
    if (path.advance(scene.factor_end * i / scene.points).status == Status::converged) add_row();
    if (told) told(i, scene.points);
  }
  curve.converged = path.state().status == Status::converged;
  curve.outcome = describe(path.state());
  curve.iterations = path.state().iterations;
  curve.residual = path.state().residual;
}

/// A straight line: two points. Any formulation gives it.
void linear_path(const Scene& scene, Curve& curve) {
  const Path<double> path(scene, formulations().front(), curve.xi);
  for (double factor : {0.0, scene.factor_end}) {
    curve.rows.push_back(
        row_of(scene, factor, [&](const std::string& output) { return path.linear_output(output, factor); }));
  }
  curve.converged = true;
  curve.outcome = "converged";
}

}  // namespace

Curve empty_curve(const Scene& scene, const Choice& choice) {
  Curve curve;
  curve.scene = scene.name;
  curve.formulation = choice.entry ? choice.entry->name : kLinearized;
  curve.xi = choice.xi;
  curve.columns = {"factor"};
  curve.columns.insert(curve.columns.end(), scene.outputs.begin(), scene.outputs.end());
  return curve;
}

std::optional<Buckling> critical_state(const Scene& scene, const Choice& choice) {
  if (scene.critical_axis == 0 || !choice.entry) return std::nullopt;
  JointSpec spec = scene.joint;
  spec.xi = choice.xi;
  return first_buckling(*choice.entry, spec, scene.critical_axis - 1);
}

Curve solve_scene(const Scene& scene, const Choice& choice, const Told& told) {
  Curve curve = empty_curve(scene, choice);
  if (choice.entry) {
    follow_path(scene, *choice.entry, told, curve);
  } else {
    linear_path(scene, curve);
  }
  return curve;
}

std::vector<Choice> choices(const Scene& scene) {
  std::vector<Choice> out;
  for (const Entry& entry : formulations()) {
    const bool wanted = scene.formulations.empty() ||
                        std::ranges::find(scene.formulations, entry.name) != scene.formulations.end();
    if (!wanted || !accepts_law(entry, scene.joint)) continue;
    if (!entry.needs_xi) {
      out.push_back({&entry, entry.probe_xi});
    } else {
      for (double xi : scene.xis) out.push_back({&entry, xi});
    }
  }
  if (scene.formulations.empty() ||
      std::ranges::find(scene.formulations, kLinearized) != scene.formulations.end()) {
    out.push_back({nullptr, 0.5});
  }
  return out;
}

}  // namespace halfway::reference
