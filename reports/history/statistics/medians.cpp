#include "reports/history/statistics/medians.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::statistics {

double median(std::span<const double> values) {
  std::vector<double> sorted(values.begin(), values.end());
  const bool has_nan = std::ranges::any_of(sorted, [](double x) { return std::isnan(x); });
  if (sorted.empty() || has_nan) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t n = sorted.size(), middle = n / 2;
  std::ranges::nth_element(sorted, sorted.begin() + std::ptrdiff_t(middle));
  if (n % 2 == 1) return sorted[middle];
  const double below = *std::ranges::max_element(sorted.begin(), sorted.begin() + std::ptrdiff_t(middle));
  return below + (sorted[middle] - below) / 2;
}

double spread(std::span<const double> values) {
  const double middle = median(values);
  std::vector<double> distances;
  for (const double x : values) distances.push_back(std::abs(x - middle));
  return 1.4826 * median(distances);
}

std::vector<double> clipped(std::span<const double> series) {
  constexpr std::size_t reach = 2;
  const std::size_t n = series.size();
  std::vector<double> locals, rest;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t from = i < reach ? 0 : i - reach, to = std::min(n, i + reach + 1);
    locals.push_back(median(series.subspan(from, to - from)));
    rest.push_back(series[i] - locals[i]);
  }
  const double most = 3 * spread(rest);
  std::vector<double> out;
  for (std::size_t i = 0; i < n; ++i)
    out.push_back(std::clamp(series[i], locals[i] - most, locals[i] + most));
  return out;
}

}  // namespace halfway::statistics
