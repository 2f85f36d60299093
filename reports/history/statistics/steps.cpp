#include "reports/history/statistics/steps.hpp"

#include "reports/history/statistics/medians.hpp"
#include "reports/history/statistics/rank_test.hpp"

#include <algorithm>
#include <cmath>

namespace halfway::statistics {
namespace {

using Series = std::span<const double>;

/// A run counts fully on its side at this share of the way from the middle to the level.
constexpr double kFull = 0.75;

/// The cut of largest energy distance between its two sides (Szekely and Rizzo): m n / (m + n) times
/// 2 mean |x - y| - mean |x - x'| - mean |y - y'|. The sums follow the cut as it moves.
std::size_t best_cut(Series x) {
  const std::size_t n = x.size();
  double across = 0, left = 0, right = 0, largest = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) right += std::abs(x[i] - x[j]);
  std::size_t best = 0;
  for (std::size_t k = 0; k + 1 < n; ++k) {
    double to_left = 0, to_right = 0;
    for (std::size_t i = 0; i < k; ++i) to_left += std::abs(x[k] - x[i]);
    for (std::size_t i = k + 1; i < n; ++i) to_right += std::abs(x[k] - x[i]);
    left += to_left, right -= to_right, across += to_right - to_left;
    const double m = double(k + 1), rest = double(n) - m;
    const double distance = 2 * across / (m * rest) - 2 * left / (m * m) - 2 * right / (rest * rest);
    const double energy = m * rest / double(n) * distance;
    if (energy > largest) largest = energy, best = k + 1;
  }
  return best;
}

class Search {
 public:
  Search(Series series, const StepRules& rules) : raw_(series), clipped_(clipped(series)), rules_(rules) {}

  std::vector<Step> run() {
    find_candidates();
    drop_weak();
    place();
    drop_weak();
    return steps_;
  }

 private:
  /// First pass: windows that overlap by half, at ten times the chance.
  void find_candidates() {
    const std::size_t n = raw_.size();
    for (std::size_t from = 0; from + 1 < n;) {
      const std::size_t known = cuts_.size();
      split(from, std::min(n, from + rules_.window));
      const std::size_t next = from + std::max<std::size_t>(1, rules_.window / 2);
      from = cuts_.size() > known ? std::max(cuts_.back(), next) : next;
    }
  }

  void split(std::size_t from, std::size_t to) {
    if (to - from < 2) return;
    const std::size_t cut = from + best_cut(Series(clipped_).subspan(from, to - from));
    if (cut == from) return;
    const double chance = chance_of_difference(raw_.subspan(from, cut - from), raw_.subspan(cut, to - cut));
    if (!(chance < 10 * rules_.chance)) return;
    split(from, cut);
    cuts_.push_back(cut);
    split(cut, to);
  }

  /// Second pass, between neighbours: the least likely goes first, then the smallest.
  void drop_weak() {
    levels_.clear(), steps_.clear();
    for (std::size_t i = 0; i <= cuts_.size(); ++i) levels_.push_back(level(i));
    for (std::size_t i = 0; i < cuts_.size(); ++i) steps_.push_back(step(i));
    for (std::size_t i = weakest(); i < cuts_.size(); i = weakest()) {
      std::vector<double> both;
      std::ranges::merge(levels_[i], levels_[i + 1], std::back_inserter(both));
      levels_[i] = std::move(both);
      levels_.erase(levels_.begin() + std::ptrdiff_t(i) + 1);
      cuts_.erase(cuts_.begin() + std::ptrdiff_t(i)), steps_.erase(steps_.begin() + std::ptrdiff_t(i));
      if (i > 0) steps_[i - 1] = step(i - 1);
      if (i < cuts_.size()) steps_[i] = step(i);
    }
  }

  /// Which step has to go; the number of steps where none has.
  std::size_t weakest() const {
    if (steps_.empty()) return 0;
    const auto size = [](const Step& s) { return std::abs(std::log(s.after / s.before)); };
    auto weakest = std::ranges::max_element(steps_, {}, &Step::chance);
    if (weakest->chance < rules_.chance) {
      weakest = std::ranges::min_element(steps_, {}, size);
      if (size(*weakest) > std::log1p(rules_.magnitude)) return steps_.size();
    }
    return std::size_t(weakest - steps_.begin());
  }

  /// Among the neighbours that are left, each where most runs lie on their own side of the middle between
  /// both levels. However far it is beyond, a run counts as one. Of equal places the last: an outlier is a
  /// slow run more often than a fast one.
  void place() {
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const double low = median(left(i)), high = median(right(i));
      const double middle = (low + high) / 2, half = (high - low) / 2;
      double sum = 0, least = 0;
      for (std::size_t run = before(i), to = after(i); run + 1 < to; ++run) {
        sum += std::clamp((raw_[run] - middle) / half, -kFull, kFull);
        if (sum <= least) least = sum, cuts_[i] = run + 1;
      }
    }
  }

  std::size_t before(std::size_t i) const { return i == 0 ? 0 : cuts_[i - 1]; }
  std::size_t after(std::size_t i) const { return i + 1 == cuts_.size() ? raw_.size() : cuts_[i + 1]; }

  Series left(std::size_t i) const { return raw_.subspan(before(i), cuts_[i] - before(i)); }
  Series right(std::size_t i) const { return raw_.subspan(cuts_[i], after(i) - cuts_[i]); }

  std::vector<double> level(std::size_t i) const {
    const Series runs = i < cuts_.size() ? left(i) : raw_.subspan(before(i));
    std::vector<double> out(runs.begin(), runs.end());
    std::ranges::sort(out);
    return out;
  }

  Step step(std::size_t i) const {
    const Series first = levels_[i], second = levels_[i + 1];
    return {cuts_[i], median(first), median(second), chance_of_difference(first, second)};
  }

  Series raw_;
  std::vector<double> clipped_;
  StepRules rules_;
  std::vector<std::size_t> cuts_;            ///< rising
  std::vector<std::vector<double>> levels_;  ///< the runs between cuts, sorted
  std::vector<Step> steps_;                  ///< at the cuts, since weak ones were last dropped
};

}  // namespace

std::vector<Step> find_steps(std::span<const double> series, const StepRules& rules) {
  return Search(series, rules).run();
}

}  // namespace halfway::statistics
