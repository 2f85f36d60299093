// The scenes of chains: every reference value, by every formulation that a scene asks for.
#include "reference/chain/scenes/solve_chain_scene.hpp"
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::ChainScene;
using reference::Choice;
using reference::SceneReference;

std::string name_of(const Choice& choice) {
  return choice.entry->needs_xi ? fmt::format("{}_xi_{:g}", choice.entry->name, choice.xi)
                                : std::string(choice.entry->name);
}

bool is_of(const SceneReference& r, const Choice& choice) {
  if (r.formulation == reference::kRod) return true;
  return r.formulation == choice.entry->name && (!choice.entry->needs_xi || r.xi == choice.xi);
}

/// The output at the reference's load factor; NaN where the chain was not solved.
double found(const ChainScene& scene, const reference::Curve& curve, const SceneReference& r) {
  const auto row = std::ranges::find(curve.rows, r.factor, [](const auto& values) { return values[0]; });
  const auto column = std::ranges::find(scene.outputs, r.output) - scene.outputs.begin();
  return row == curve.rows.end() ? std::nan("") : tapped((*row)[std::size_t(column) + 1]);
}

Finding compared(const ChainScene& scene, const reference::Curve& curve, const SceneReference& r,
                 const std::string& formulation, std::size_t place) {
  const double expected = std::stod(r.value);
  const double limit = r.absolute ? r.tolerance : r.tolerance * std::abs(expected);
  // A value may be known from several sources.
  return finding(fmt::format("chains/scenes/{}/{}/{}@{:g}/{}", scene.name, formulation, r.output, r.factor,
                             place))
      .about(scene.name)
      .of(curve.formulation)
      .measured(found(scene, curve, r), curve.outcome)
      .in(r.output.size() == 1 ? "m" : "rad")
      .equal(expected, limit, r.reason + "; " + r.source)
      .by(r.oracle);
}

std::vector<Finding> answers(const ChainScene& scene) {
  const auto has_batch = [](const reference::Entry& entry) {
    const auto all = chain_formulations();
    return std::ranges::find(all, &entry) != all.end();
  };
  std::vector<Finding> out;
  for (const Choice& choice : reference::choices(scene, has_batch)) {
    const reference::Curve curve = reference::solve_chain_scene(scene, choice).curve;
    for (std::size_t i = 0; i < scene.references.size(); ++i) {
      const SceneReference& r = scene.references[i];
      if (is_of(r, choice)) out.push_back(compared(scene, curve, r, name_of(choice), i));
    }
  }
  return out;
}

}  // namespace

void chain_answers(Checks& checks) {
  for (const ChainScene& scene : chains()) {
    checks.push_back({"chains/scenes/" + scene.name, "chains", [&scene] { return answers(scene); }});
  }
}

}  // namespace halfway::verify
