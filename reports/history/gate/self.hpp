// The gate on itself: alarms between programs of one source, and how many seeded slow-downs it finds.
#pragma once

#include "reports/history/gate/times.hpp"

namespace halfway::gate {

struct SelfPlan {
  std::vector<std::filesystem::path> programs{};  ///< layouts of one source; at least four
  int runs = 200;  ///< comparisons without a slow-down; 0: limits are rules.allowed
  std::vector<double> slower{0.03, 0.05, 0.10, 0.20};
  int slowed_runs = 50;  ///< of each slow-down
  BenchOptions bench{};
  TimeRules rules{};
  std::string command{};  ///< that makes it again, kept with the result
};

/// The comparison a run makes: up to three layouts a side, drawn from the first half of them (even runs) or
/// from the second, none on both sides.
struct Sides {
  Side base, head;
};
Sides sides_of(const SelfPlan& plan, int run);

/// The file of the result: self.json, or power.json of slow-downs alone.
std::string result_name(const SelfPlan& plan);

/// Measures what the journal does not have, and writes the result into the folder. What each figure is
/// allowed is the largest change that layouts alone made of it, no less than rules.least. The false alarms
/// that count are those of the odd runs under what the even ones allow: other layouts, other runs.
void measure_self(const SelfPlan& plan, Journal& journal, const std::filesystem::path& folder,
                  const Told& told);

/// What a self.json allows each figure. Throws reports::BadInput that names the file.
std::map<std::string, double> read_allowed(const std::filesystem::path& file);

}  // namespace halfway::gate
