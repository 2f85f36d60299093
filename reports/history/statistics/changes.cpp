#include "reports/history/statistics/changes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace halfway::statistics {

std::vector<Change> find_changes(std::span<const double> medians, const StepRules& rules) {
  std::vector<double> series;
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < medians.size(); ++i) {
    if (std::isnan(medians[i])) continue;
    if (!(medians[i] > 0)) throw std::invalid_argument(fmt::format("a time of {}", medians[i]));
    series.push_back(medians[i]), runs.push_back(i);
  }
  std::vector<Change> out;
  for (const Step& step : find_steps(series, rules)) {
    Change c;
    c.run = runs[step.at];
    c.sense = step.after > step.before ? Sense::regression : Sense::improvement;
    c.before = step.before, c.after = step.after, c.ratio = step.after / step.before, c.chance = step.chance;
    c.text = fmt::format("time {:+.1f} %", 100 * (c.ratio - 1));
    out.push_back(c);
  }
  return out;
}

std::vector<Change> find_changes(std::span<const Exact> readings) {
  std::vector<Change> out;
  std::size_t level = 0;
  for (std::size_t i = 1; i < readings.size(); ++i) {
    auto change = exact_change(readings[i - 1], readings[i]);
    if (!change) continue;
    // A digit lost in parts, one commit after another, is lost at the last of them.
    if (change->sense == Sense::change) {
      const auto since = exact_change(readings[level], readings[i]);
      if (since && since->sense == Sense::regression) change = since;
    }
    if (change->sense != Sense::change) level = i;
    Change c;
    c.run = i, c.sense = change->sense;
    c.before = readings[i - 1].value, c.after = readings[i].value;
    c.digits = change->digits, c.text = change->text;
    out.push_back(c);
  }
  return out;
}

}  // namespace halfway::statistics
