// Limits of the machine, targets and choices: the object `speed` of results.json, see SCHEMA.md.
#pragma once

#include "bench/peak/peak.hpp"
#include "reports/views/results.hpp"

namespace halfway::reports {

/// Measures bandwidths in this process and holds the run's timings against its peaks and the targets.
nlohmann::json speed_record(const Results& results, const bench::Peaks& peaks);

/// One target: a ratio of two medians of this run, or an error.
struct Target {
  std::string name;
  double value = 0;  ///< NaN: not measured
  double limit = 0;
  bool at_least = true;
  std::string note;
  bool met() const { return at_least ? value >= limit : value <= limit; }
};

/// The targets of the kernels and batches, in the order of the table.
std::vector<Target> speed_targets(const std::vector<bench::Timing>& timings, const bench::Peaks& peaks);

}  // namespace halfway::reports
