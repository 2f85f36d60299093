#include "verify/studies/scenes/model_error.hpp"

#include "reference/face/kernel_variants.hpp"
#include "reference/record/worst.hpp"
#include "reference/solve/path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace halfway::verify {
namespace {

using reference::Curve;
using reference::Scene;

constexpr double kMirrorSymmetric = 0.5;  ///< no other xi is possible to second order, for any elastic law

reference::Choice form_of(const Scene& scene) {
  const auto skewed =
      std::find_if(scene.xis.rbegin(), scene.xis.rend(), [](double xi) { return xi != kMirrorSymmetric; });
  const bool symmetric = skewed == scene.xis.rend();
  const auto* entry = reference::find_formulation(symmetric ? "invariant" : "intrinsic");
  if (entry == nullptr) throw std::logic_error("the catalog lacks the paper's forms");
  return {entry, symmetric ? kMirrorSymmetric : *skewed};
}

Curve solved_exactly(const Scene& scene, const reference::Choice& choice) {
  Curve curve;
  curve.scene = scene.name;
  curve.formulation = choice.entry->name;
  curve.xi = choice.xi;
  curve.columns = {"factor"};
  curve.columns.insert(curve.columns.end(), scene.outputs.begin(), scene.outputs.end());
  reference::Path<reference::Real50> path(scene, *choice.entry, choice.xi);
  for (int i = 1; i <= scene.points; ++i) {
    if (path.advance(scene.factor_end * i / scene.points).status != Status::converged) return curve;
    std::vector<double> row{double(path.state().factor)};
    for (const std::string& output : scene.outputs) row.push_back(double(path.output(output)));
    curve.rows.push_back(std::move(row));
  }
  curve.converged = true;
  return curve;
}

/// Of the columns whose name begins so; 0 where the truth has none or nothing else than zero. NaN where the
/// two have no load in common.
double error_of(const std::string& prefix, const Curve& path, const Curve& truth) {
  reference::Measurement size, miss;
  bool has_columns = false;
  for (std::size_t column = 1; column < truth.columns.size(); ++column) {
    if (!truth.columns[column].starts_with(prefix)) continue;
    has_columns = true;
    for (const auto& exact : truth.rows) {
      const auto same = [&](const auto& row) {
        return std::abs(row[0] - exact[0]) <= 1e-12 * std::abs(exact[0]);
      };
      const auto row = std::ranges::find_if(path.rows, same);
      if (row == path.rows.end()) continue;
      size.include(std::abs(exact[column]), {});
      miss.include(std::abs((*row)[column] - exact[column]), {});
    }
  }
  return !has_columns || size.value() == 0 ? 0 : miss.value() / size.value();
}

}  // namespace

Truth truth_of(const Scene& scene) {
  Truth truth;
  truth.choice = form_of(scene);
  truth.curve = solved_exactly(scene, truth.choice);
  truth.described = truth.choice.entry->needs_xi
                        ? fmt::format("truth: {} with the scene's xi = {} at 50 digits",
                                      truth.curve.formulation, truth.choice.xi)
                        : fmt::format("truth: {} at 50 digits, since the scene has no xi other than 1/2",
                                      truth.curve.formulation);
  return truth;
}

std::optional<reference::Entry> evaluated_by(std::string_view implementation, std::string_view variant,
                                             std::string_view precision, const reference::Entry& entry,
                                             const Scene& scene) {
  if (implementation == "reference") return variant.empty() ? std::optional(entry) : std::nullopt;
  const bool linear = std::holds_alternative<reference::LinearSpec>(scene.joint.law);
  if (!linear || entry.kernel.in_double.angular == nullptr) return std::nullopt;
  if (variant.empty()) return with_kernel(entry, precision == "float");
  if (entry.name != "invariant" || scene.joint.kind != Kind::angular) return std::nullopt;
  for (const auto& known : reference::invariant_variants())
    if (known.name == variant && known.precision == precision) return with_variant(entry, known);
  return std::nullopt;
}

std::optional<double> model_error(const Curve& path, const Truth& truth) {
  if (!path.converged || !truth.curve.converged || path.columns != truth.curve.columns) return std::nullopt;
  const double error =
      reference::larger(error_of("theta_", path, truth.curve), error_of("u_", path, truth.curve));
  if (!std::isfinite(error)) return std::nullopt;
  return reference::larger(error, std::numeric_limits<double>::epsilon() / 2);
}

}  // namespace halfway::verify
