// Where does a noisy series change its level? Hunter's two passes (Fleming et al., "Hunter: Using Change
// Point Detection to Hunt for Performance Regressions", ICPE 2023) on clipped medians, with ranks where it
// has Student's t.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace halfway::statistics {

struct StepRules {
  double chance = 0.001;    ///< two-sided, of the ranks on both sides
  double magnitude = 0.03;  ///< relative change of the median
  std::size_t window = 50;  ///< runs that are looked at together for candidates
};

struct Step {
  std::size_t at = 0;            ///< the first number of the new level
  double before = 0, after = 0;  ///< medians of the levels
  double chance = 1;             ///< that there is no step
};

/// By rising position. The numbers are positive, and none is NaN.
std::vector<Step> find_steps(std::span<const double> series, const StepRules& rules = {});

}  // namespace halfway::statistics
