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

/// Ranks of all numbers, doubled so that mid-ranks are whole numbers.
struct Ranks {
  std::vector<int> rising;
  long sum_a = 0, sum_b = 0;
  bool tied = false;
  double tie_sum = 0;  ///< of t^3 - t over groups of t equal numbers
};

/// What is sorted already costs a look: a search for steps asks often for the same levels.
std::vector<double> sorted(std::span<const double> group) {
  std::vector<double> out(group.begin(), group.end());
  if (group.empty() || std::ranges::any_of(out, [](double x) { return std::isnan(x); }))
    throw std::invalid_argument("ranks need numbers in both groups");
  if (!std::ranges::is_sorted(out)) std::ranges::sort(out);
  return out;
}

Ranks ranks_of(std::span<const double> group_a, std::span<const double> group_b) {
  const std::vector<double> a = sorted(group_a), b = sorted(group_b);
  Ranks out;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    const bool is_from_a = j == b.size() || (i < a.size() && a[i] < b[j]);
    const double value = is_from_a ? a[i] : b[j];
    const std::size_t first = i + j, first_i = i, first_j = j;
    while (i < a.size() && a[i] == value) ++i;
    while (j < b.size() && b[j] == value) ++j;
    const std::size_t next = i + j;
    const int rank = int(first + next + 1);
    out.sum_a += long(i - first_i) * rank, out.sum_b += long(j - first_j) * rank;
    out.rising.insert(out.rising.end(), next - first, rank);
    const double t = double(next - first);
    out.tied = out.tied || t > 1;
    out.tie_sum += t * t * t - t;
  }
  return out;
}

/// [u]: ways to choose `chosen` of the ranks whose sum is at most u above the least one; u up to `most`.
/// Sums of positive numbers: no digit is lost.
std::vector<double> ways_up_to(std::size_t most, const std::vector<int>& rising, std::size_t chosen) {
  // [k][u]: of k ranks, with a sum of just that. A further rank is no smaller than any before it: u never
  // falls. A row is filled as far as it is reached; what is beyond is left of the call before.
  thread_local std::vector<double> ways;
  const std::size_t row = most + 1;
  ways.resize(std::max(ways.size(), (chosen + 1) * row));
  std::vector<std::size_t> reached(chosen + 1, 0);  // a row's length
  ways[0] = 1, reached[0] = 1;
  for (std::size_t i = 0, n = rising.size(); i < n; ++i) {
    const std::size_t later = n - 1 - i, least = chosen > later ? chosen - later : 1;
    for (std::size_t k = std::min(chosen, i + 1); k >= least; --k) {
      const std::size_t more = std::size_t(rising[i] - rising[k - 1]);
      const std::size_t end = std::min(row, std::max(reached[k], reached[k - 1] + more));
      double* const to = ways.data() + k * row;
      const double* const from = ways.data() + (k - 1) * row;
      std::fill(to + std::min(reached[k], end), to + end, 0.0);
      reached[k] = end;
      for (std::size_t u = more, stop = std::min(end, reached[k - 1] + more); u < stop; ++u)
        to[u] += from[u - more];
    }
  }
  double* const last = ways.data() + chosen * row;
  std::fill(last + reached[chosen], last + row, 0.0);
  std::vector<double> out(last, last + row);
  std::partial_sum(out.begin(), out.end(), out.begin());
  return out;
}

/// Without ties they depend on the numbers of ranks alone, and are kept.
const std::vector<double>& untied_ways(std::size_t all, std::size_t chosen) {
  thread_local std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> kept;
  std::vector<double>& ways = kept[{all, chosen}];
  if (ways.empty()) {
    std::vector<int> ranks(all);
    std::iota(ranks.begin(), ranks.end(), 1);
    ways = ways_up_to(chosen * (all - chosen), ranks, chosen);
  }
  return ways;
}

double ways_to_choose(std::size_t chosen, std::size_t all) {
  double out = 1;
  for (std::size_t k = 1; k <= chosen; ++k) out = out * double(all - chosen + k) / double(k);
  return out;
}

/// Shares of all ways to choose: those with at most this sum, and those with this one.
struct Tail {
  double at_most = 0, equal = 0;
};

Tail tail_of(const Ranks& ranks, std::size_t chosen, long sum) {
  const auto end_of_least = ranks.rising.begin() + std::ptrdiff_t(chosen);
  std::size_t u = std::size_t(sum - std::accumulate(ranks.rising.begin(), end_of_least, 0L));
  if (!ranks.tied) u /= 2;
  const auto tied = ranks.tied ? ways_up_to(u, ranks.rising, chosen) : std::vector<double>{};
  const auto& ways = ranks.tied ? tied : untied_ways(ranks.rising.size(), chosen);
  const double all = ways_to_choose(chosen, ranks.rising.size());
  return {ways[u] / all, (ways[u] - (u > 0 ? ways[u - 1] : 0)) / all};
}

/// Counted from above: what was high is low.
Ranks mirrored(Ranks ranks) {
  const int ends = 2 * int(ranks.rising.size() + 1);
  std::ranges::reverse(ranks.rising);
  for (int& rank : ranks.rising) rank = ends - rank;
  return ranks;
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
  const std::size_t m = a.size(), n = b.size();
  if (m + n > kExactUpTo) return normal_chance(ranks, double(m), double(n), double(ranks.sum_b));
  if (m < n) return tail_of(ranks, m, ranks.sum_a).at_most;
  return tail_of(mirrored(ranks), n, long(n) * 2 * long(m + n + 1) - ranks.sum_b).at_most;
}

double chance_of_difference(std::span<const double> a, std::span<const double> b) {
  const Ranks ranks = ranks_of(a, b);
  const std::size_t m = a.size(), n = b.size();
  if (m + n > kExactUpTo) {
    const double higher = normal_chance(ranks, double(m), double(n), double(ranks.sum_b));
    return std::min(1.0,
                    2 * std::min(higher, normal_chance(ranks, double(n), double(m), double(ranks.sum_a))));
  }
  // From the side on which the smaller group lies: its tail is the short one, and as good as always the
  // smaller.
  const std::size_t chosen = std::min(m, n);
  const long sum = m < n ? ranks.sum_a : ranks.sum_b, both = 2 * long(m + n + 1) * long(chosen);
  const Tail tail =
      2 * sum > both ? tail_of(mirrored(ranks), chosen, both - sum) : tail_of(ranks, chosen, sum);
  return std::min(1.0, 2 * std::min(tail.at_most, 1 - tail.at_most + tail.equal));
}

}  // namespace halfway::statistics
