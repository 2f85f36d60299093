#include "reports/advise/model/answers.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace halfway::advise {
namespace {

constexpr double kNothing = 1e-9;  ///< of the largest output of its unit: none

/// The largest |output| of each unit over all rows; 1 rad or 1 m where there is none.
std::map<std::string_view, double> sizes_of(const Answers& truth) {
  std::map<std::string_view, double> out;
  for (const auto& row : truth.value) {
    for (std::size_t i = 0; i < row.size(); ++i)
      reference::keep_largest(out[reference::unit_of_output(truth.outputs[i])], std::abs(row[i]));
  }
  for (auto& [unit, size] : out) size = size == 0 ? 1 : size;
  return out;
}

double error_of_row(const Answers& truth, const std::vector<double>& model, const std::vector<double>& exact,
                    const std::map<std::string_view, double>& sizes, Measure measure) {
  std::map<std::string_view, double> off, whole;
  double worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) {
    const std::string_view unit = reference::unit_of_output(truth.outputs[i]);
    off[unit] = std::hypot(off[unit], model[i] - exact[i]);
    whole[unit] = std::hypot(whole[unit], exact[i]);
    if (measure != Measure::each) continue;
    const double size = std::abs(exact[i]) > kNothing * sizes.at(unit) ? std::abs(exact[i]) : sizes.at(unit);
    reference::keep_largest(worst, std::abs(model[i] - exact[i]) / size);
  }
  if (measure == Measure::each) return worst;
  for (const auto& [unit, difference] : off) {
    const double size = whole[unit] > kNothing * sizes.at(unit) ? whole[unit] : sizes.at(unit);
    reference::keep_largest(worst, difference / size);
  }
  return worst;
}

}  // namespace

const char* to_string(Measure measure) { return measure == Measure::norm ? "norm" : "each"; }

std::vector<double> errors_of(const Answers& model, const Answers& truth, Measure measure) {
  const auto sizes = sizes_of(truth);
  std::vector<double> out;
  for (std::size_t i = 0; i < truth.value.size(); ++i) {
    out.push_back(i < model.value.size() ? error_of_row(truth, model.value[i], truth.value[i], sizes, measure)
                                         : std::numeric_limits<double>::infinity());
  }
  return out;
}

double worst_of(const std::vector<double>& errors, std::size_t rows) {
  if (rows == 0 || errors.empty()) return std::nan("");
  double worst = 0;
  for (std::size_t i = 0; i < std::min(rows, errors.size()); ++i) reference::keep_largest(worst, errors[i]);
  return worst;
}

Reach reach_of(const std::vector<double>& errors, const Answers& truth, double tolerance) {
  Reach last;
  double last_error = 0;
  for (std::size_t i = 0; i < std::min(errors.size(), truth.value.size()); ++i) {
    const double rotation = rotation_at(truth, i).value_or(0);
    if (!(errors[i] <= tolerance)) {
      // Half-way laws err with the square of the load: from the first row on nothing is known between.
      const double share =
          i == 0 || !std::isfinite(errors[i]) ? 0 : (tolerance - last_error) / (errors[i] - last_error);
      return {last.factor + share * (truth.factor[i] - last.factor),
              last.rotation + share * (rotation - last.rotation), false};
    }
    last = {truth.factor[i], rotation, true};
    last_error = errors[i];
  }
  return last;
}

std::optional<double> rotation_at(const Answers& answers, std::size_t row) {
  double square = 0;
  int components = 0;
  for (std::size_t i = 0; i < answers.outputs.size(); ++i) {
    if (!answers.outputs[i].starts_with("theta_")) continue;
    square += answers.value[row][i] * answers.value[row][i];
    ++components;
  }
  return components == 3 ? std::optional(std::sqrt(square)) : std::nullopt;
}

}  // namespace halfway::advise
