// What the formulations of a run agree on: groups of equal answers, and who ended early, why.
#pragma once

#include "reports/cli/run/run_choices.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reports {

/// Answers nearer than this share of the answer are one: what a reader would not tell apart in a chart.
inline constexpr double kAgree = 0.01;

/// Curves, by their place in the run, whose last points agree pairwise.
struct Agreeing {
  std::vector<std::size_t> curves;
  std::vector<double> answer{};  ///< the first one's outputs; 0 where less than its error, or rounding
  double apart = 0;              ///< largest difference of two of them, over the answer
  std::optional<double>
      error{};  ///< largest that one of them carries, rad or m; the linear analysis has none
};

/// Curves that ended early for one cause.
struct Ended {
  std::string cause;
  std::vector<std::size_t> curves;
};

/// Neither the linear analysis nor a rod.
bool is_formulation(const reference::Curve& curve);

/// Differences are norms over all outputs of a unit, over the largest such norm that a path has moved from
/// its first point by; what two errors explain is none.
struct Comparison {
  std::vector<Agreeing> groups;  ///< of those that reached the last load factor, in the order of the run
  std::vector<Ended> ended;
  std::size_t answers = 0;  ///< groups with a formulation in them
  double apart = 0;         ///< largest difference of any two formulations' answers
};
Comparison compared(const std::vector<reference::Curve>& curves);

}  // namespace halfway::reports
