// The middle of some numbers, and a series without its outliers.
#pragma once

#include <span>
#include <vector>

namespace halfway::statistics {

/// Of an even number the mean of both in the middle; NaN of none, and where one is NaN.
double median(std::span<const double> values);

/// 1.4826 times the median distance from the median: the standard deviation, of a normal distribution.
double spread(std::span<const double> values);

/// Each number, moved no further than three spreads from the median of itself and its two neighbours on
/// either side. An outlier goes, a step stays where it is. No NaN among the numbers.
std::vector<double> clipped(std::span<const double> series);

}  // namespace halfway::statistics
