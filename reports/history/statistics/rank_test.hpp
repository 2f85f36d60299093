// Is one group of numbers higher than another? By ranks: an outlier counts as one, whatever its size.
#pragma once

#include <span>

namespace halfway::statistics {

/// Mann and Whitney's test, one-sided: the chance that `b` ranks at least as high above `a` as it does if
/// both are draws from one distribution. Exact up to 100 numbers, with ties at their mid-ranks; beyond, the
/// normal approximation with corrections for ties and continuity. Throws std::invalid_argument of an empty
/// group and of NaN: what was not measured has no rank.
double chance_of_higher(std::span<const double> a, std::span<const double> b);

/// The same for a difference either way: twice the smaller of both, at most 1.
double chance_of_difference(std::span<const double> a, std::span<const double> b);

}  // namespace halfway::statistics
