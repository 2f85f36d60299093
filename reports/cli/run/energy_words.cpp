#include "reports/cli/run/energy_words.hpp"

#include "reference/record/worst.hpp"
#include "reports/cli/run/run_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

namespace halfway::reports {
namespace {

using reference::Curve;
using reference::MechanismScene;

bool has_potential(const MechanismScene& scene, const Curve& curve) {
  const auto* entry = reference::find_formulation(curve.formulation);
  return entry && std::ranges::all_of(
                      scene.joints, [&](const auto& joint) { return entry->has_potential(joint.spec.kind); });
}

/// What dampers took at the end: from the least to the most of all curves.
std::string dissipated(const std::vector<Curve>& curves) {
  reference::Extent taken;
  for (const Curve& curve : curves)
    if (curve.converged) taken.include(curve.energies.back()[2]);
  if (!(taken.high() > 0)) return "";
  const bool is_one = taken.high() - taken.low() <= 1e-3 * taken.high();
  return is_one ? fmt::format("dampers take {:.4g} J; ", taken.high())
                : fmt::format("dampers take {:.4g} to {:.4g} J; ", taken.low(), taken.high());
}

/// Shares with those that have them, the largest first.
std::string listed(std::vector<std::pair<double, std::string>> made) {
  std::ranges::stable_sort(made, std::greater<>(), &std::pair<double, std::string>::first);
  std::string out, last;
  for (const auto& [share, name] : made) {
    const std::string text = fmt::format("{:.1e}", share);
    out += text == last ? ", " + name : fmt::format("{}{} {}", out.empty() ? "" : "; ", text, name);
    last = text;
  }
  return out;
}

}  // namespace

std::string energy_words(const MechanismScene& scene, const std::vector<Curve>& curves) {
  constexpr double kFelt = 10;  // times what the integration leaves: below, nobody can tell whose it is
  reference::Measurement integrated;
  for (const Curve& curve : curves)
    if (has_potential(scene, curve)) integrated.include(curve.residual, curve.formulation);
  std::vector<std::pair<double, std::string>> made;
  for (const Curve& curve : curves) {
    const bool is_rounding = !integrated.is_empty() && curve.residual <= kFelt * integrated.value();
    if (!has_potential(scene, curve) && !is_rounding && curve.residual > 0)
      made.emplace_back(curve.residual, curve_label(curve));
  }
  std::string out = fmt::format("  energy, balance over the largest there was: {}", dissipated(curves));
  out += integrated.is_empty()
             ? "no joint here has a potential\n"
             : fmt::format("off by {:.0e} at most where joints have a potential\n", integrated.value());
  if (made.empty()) return out;
  return fmt::format("{}  without a potential the law itself makes or loses {}\n", out, listed(made));
}

}  // namespace halfway::reports
