// The scenes of mechanisms, at rest and in time: every reference value, in double.
#include "reference/mechanism/motion/solve_motion.hpp"
#include "reference/mechanism/solve.hpp"

#include "reference/scene/any_scene.hpp"
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace halfway::verify {
namespace {

using reference::Curve;
using reference::MechanismScene;
using reference::SceneReference;

const std::vector<MechanismScene>& mechanisms() {
  static const std::vector<MechanismScene> kept = [] {
    std::vector<MechanismScene> out = reference::mechanism_scenes();
    for (const MechanismScene& scene : reference::motion_scenes()) out.push_back(scene);
    return out;
  }();
  return kept;
}

/// Of a row at the factor; NaN where there is none.
double value_of(const Curve& curve, const SceneReference& r) {
  const auto column = std::ranges::find(curve.columns, r.output) - curve.columns.begin();
  for (const auto& row : curve.rows)
    if (std::abs(row[0] - r.factor) <= 1e-12 * r.factor) return row[std::size_t(column)];
  return std::nan("");
}

std::vector<Finding> solved(const MechanismScene& scene, const std::string& formulation,
                            const std::vector<SceneReference>& references) {
  const reference::Choice choice{reference::find_formulation(formulation), references.front().xi};
  const Curve curve =
      scene.time ? reference::solve_motion(scene, choice) : reference::solve_scene(scene, choice);
  std::vector<Finding> out;
  for (const SceneReference& r : references) {
    const double expected = std::stod(r.value.empty() ? "0" : r.value);
    const double limit = r.absolute ? r.tolerance : r.tolerance * std::abs(expected);
    const bool is_critical = reference::is_critical(r.output);
    const double found =
        is_critical ? reference::critical_factor(scene, choice).value_or(0) : value_of(curve, r);
    out.push_back(finding(fmt::format("{}/{}/{}{}", scene.name, formulation, r.output,
                                      is_critical ? "" : fmt::format("@{:g}", r.factor)))
                      .of(formulation)
                      .about(scene.name)
                      .in(std::string(reference::unit_of_output(r.output)))
                      .measured(tapped(found), curve.outcome)
                      .equal(expected, limit, r.reason + "; " + r.source)
                      .by(r.oracle, limit));
  }
  return out;
}

}  // namespace

void mechanism_scenes(Checks& checks) {
  for (const MechanismScene& scene : mechanisms()) {
    std::map<std::string, std::vector<SceneReference>> by_formulation;
    for (const SceneReference& r : scene.references) by_formulation[r.formulation].push_back(r);
    for (const auto& item : by_formulation) {
      const std::string formulation = item.first;
      const std::vector<SceneReference> references = item.second;
      checks.push_back({scene.name + "/" + formulation, "mechanisms", [&scene, formulation, references] {
                          return solved(scene, formulation, references);
                        }});
    }
  }
}

}  // namespace halfway::verify
