#include "reports/history/statistics/rank_test.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

namespace halfway::statistics {
namespace {

constexpr std::size_t kExactUpTo = 100;

/// Ranks, doubled so that mid-ranks are whole numbers; those of `a` first.
struct Ranks {
  std::vector<int> doubled;
  bool tied = false;
  double tie_sum = 0;  ///< of t^3 - t over groups of t equal numbers
};

Ranks ranks_of(std::span<const double> a, std::span<const double> b) {
  std::vector<double> all(a.begin(), a.end());
  all.insert(all.end(), b.begin(), b.end());
  if (a.empty() || b.empty() || std::ranges::any_of(all, [](double x) { return std::isnan(x); }))
    throw std::invalid_argument("ranks need numbers in both groups");
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return all[i]; });
  Ranks out;
  out.doubled.resize(all.size());
  for (std::size_t first = 0, next = 0; first < order.size(); first = next) {
    while (next < order.size() && all[order[next]] == all[order[first]]) ++next;
    for (std::size_t i = first; i < next; ++i) out.doubled[order[i]] = int(first + next + 1);
    const double t = double(next - first);
    out.tied = out.tied || t > 1;
    out.tie_sum += t * t * t - t;
  }
  return out;
}

/// [s]: ways to choose `chosen` of the ranks with doubled sum s. Sums of positive numbers: no digit is lost.
std::vector<double> ways_by_sum(const std::vector<int>& ranks, std::size_t chosen) {
  const std::size_t most = std::size_t(std::accumulate(ranks.begin(), ranks.end(), 0));
  std::vector<std::vector<double>> ways(chosen + 1, std::vector<double>(most + 1, 0.0));
  ways[0][0] = 1;
  std::size_t reached = 0;
  for (const int rank : ranks) {
    reached += std::size_t(rank);
    for (std::size_t k = chosen; k > 0; --k) {
      for (std::size_t s = std::size_t(rank); s <= reached; ++s)
        ways[k][s] += ways[k - 1][s - std::size_t(rank)];
    }
  }
  return ways[chosen];
}

/// Without ties they depend on the numbers of ranks alone, and are kept.
const std::vector<double>& untied_ways(std::size_t all, std::size_t chosen) {
  thread_local std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> kept;
  std::vector<double>& ways = kept[{all, chosen}];
  if (ways.empty()) {
    std::vector<int> ranks(all);
    for (std::size_t i = 0; i < all; ++i) ranks[i] = 2 * int(i + 1);
    ways = ways_by_sum(ranks, chosen);
  }
  return ways;
}

/// Of the smaller group's sum: at least (or at most) `sum`.
double exact_chance(const Ranks& ranks, std::size_t chosen, int sum, bool at_least) {
  const auto tied = ranks.tied ? ways_by_sum(ranks.doubled, chosen) : std::vector<double>{};
  const std::vector<double>& ways = ranks.tied ? tied : untied_ways(ranks.doubled.size(), chosen);
  const double all = std::accumulate(ways.begin(), ways.end(), 0.0);
  const double beyond = at_least ? std::accumulate(ways.begin() + sum, ways.end(), 0.0)
                                 : std::accumulate(ways.begin(), ways.begin() + sum + 1, 0.0);
  return beyond / all;
}

double normal_chance(const Ranks& ranks, double m, double n, double doubled_sum_of_b) {
  const double u = doubled_sum_of_b / 2 - n * (n + 1) / 2, all = m + n;
  const double variance = m * n / 12 * (all + 1 - ranks.tie_sum / (all * (all - 1)));
  if (!(variance > 0)) return 1;  // all are equal
  return gsl_cdf_ugaussian_Q((u - m * n / 2 - 0.5) / std::sqrt(variance));
}

}  // namespace

double chance_of_higher(std::span<const double> a, std::span<const double> b) {
  const Ranks ranks = ranks_of(a, b);
  const auto middle = ranks.doubled.begin() + std::ptrdiff_t(a.size());
  const int sum_a = std::accumulate(ranks.doubled.begin(), middle, 0);
  const int sum_b = std::accumulate(middle, ranks.doubled.end(), 0);
  if (a.size() + b.size() > kExactUpTo)
    return normal_chance(ranks, double(a.size()), double(b.size()), sum_b);
  return b.size() <= a.size() ? exact_chance(ranks, b.size(), sum_b, true)
                              : exact_chance(ranks, a.size(), sum_a, false);
}

double chance_of_difference(std::span<const double> a, std::span<const double> b) {
  return std::min(1.0, 2 * std::min(chance_of_higher(a, b), chance_of_higher(b, a)));
}

}  // namespace halfway::statistics
