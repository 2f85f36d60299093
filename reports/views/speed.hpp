// Limits of the machine, targets and choices: the object `speed` of results.json, see SCHEMA.md.
#pragma once

#include "reports/views/results.hpp"

namespace halfway::reports {

/// Measures bandwidths in this process and holds the run's timings against its peaks and the targets.
nlohmann::json speed_record(const Results& results, const bench::Run& run);

/// One target: a ratio of two medians of this run, or an error.
struct Target {
  std::string name;
  double value = 0;  ///< NaN: not measured
  double limit = 0;
  bool at_least = true;
  std::string note;
  bool met() const { return at_least ? value >= limit : value <= limit; }
};

/// The targets of the kernels, batches and assemblies, in the order of the table. Those of several threads
/// have no value where others are at work on the cores.
std::vector<Target> speed_targets(const bench::Run& run);

}  // namespace halfway::reports
