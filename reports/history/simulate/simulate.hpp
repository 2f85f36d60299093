// Histories that never happened, with regressions at commits that are known: how many are found, and how many
// figures that never changed are marked?
#pragma once

#include "reports/history/statistics/steps.hpp"

#include <string>
#include <vector>

namespace halfway::history {

/// Of the medians of runs, about one level.
enum class Noise {
  student,  ///< Student's t of three degrees of freedom, standard deviation 2 %
  normal,   ///< standard deviation 2 %
  spikes,   ///< 1.5 %, and one run in twenty is slower, by 10 % in the mean (exponential)
  wide,     ///< Student's t whose middle is as wide as that of the normal one: standard deviation 3.1 %
};
const char* to_string(Noise noise);

struct Plan {
  int seeds = 200;
  int runs = 60;
  int times = 60, accuracies = 40;  ///< figures of a history; in 3 and in 2 of them is a regression
  double slower = 0.10;             ///< of the seeded times
  int runs_after = 10;              ///< at least, from the seeded commit on
  int runs_before = 6;              ///< at least: of fewer, no test of ranks at 0.001 could tell
  statistics::StepRules rules{};
};

struct Tally {
  int seeded = 0, found = 0;  ///< found: a regression marked at the seeded commit or a neighbour
  int exactly = 0;            ///< of those, at the commit itself
  int stable = 0, marked = 0;
};

struct Result {
  Noise noise;
  Tally times, accuracies;
};

/// The same numbers for the same plan, on every machine with the same standard library.
Result simulate(const Plan& plan, Noise noise);

}  // namespace halfway::history
