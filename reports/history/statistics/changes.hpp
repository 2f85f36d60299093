// The changes in the history of one figure: at which run, how much, and how sure.
#pragma once

#include "reports/history/statistics/exact.hpp"
#include "reports/history/statistics/steps.hpp"

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <vector>

namespace halfway::statistics {

struct Change {
  std::size_t run = 0;  ///< index into the series: the first run that has it
  Sense sense = Sense::change;
  double before = 0, after = 0;                              ///< medians of the levels; values
  double ratio = std::numeric_limits<double>::quiet_NaN();   ///< of times: after / before
  double digits = std::numeric_limits<double>::quiet_NaN();  ///< of accuracy: gained
  double chance = std::numeric_limits<double>::quiet_NaN();  ///< of times: that there is no step
  std::string text;                                          ///< "time +10.2 %", "pass -> fail; ..."
};

/// Of times, medians of each run, smaller is better. A run that did not measure it is NaN and is passed over.
/// Throws std::invalid_argument of a time that is not positive.
std::vector<Change> find_changes(std::span<const double> medians, const StepRules& rules = {});

/// Of a deterministic figure, one reading a run: each against the one before it, and against the last one
/// that was a regression or an improvement.
std::vector<Change> find_changes(std::span<const Exact> readings);

}  // namespace halfway::statistics
