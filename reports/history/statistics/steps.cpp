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
    std::vector<Step> out;
    for (std::size_t i = 0; i < cuts_.size(); ++i) out.push_back(step(i));
    return out;
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
    if (cut == from || !(chance(from, cut, to) < 10 * rules_.chance)) return;
    split(from, cut);
    cuts_.push_back(cut);
    split(cut, to);
  }

  void drop_weak() {
    while (drop_weakest()) {
    }
  }

  /// Second pass, between neighbours: the least likely goes first, then the smallest.
  bool drop_weakest() {
    if (cuts_.empty()) return false;
    std::vector<Step> steps;
    for (std::size_t i = 0; i < cuts_.size(); ++i) steps.push_back(step(i));
    const auto size = [](const Step& s) { return std::abs(std::log(s.after / s.before)); };
    auto weakest = std::ranges::max_element(steps, {}, &Step::chance);
    if (weakest->chance < rules_.chance) {
      weakest = std::ranges::min_element(steps, {}, size);
      if (size(*weakest) > std::log1p(rules_.magnitude)) return false;
    }
    cuts_.erase(cuts_.begin() + (weakest - steps.begin()));
    return true;
  }

  /// Among the neighbours that are left, each where most runs lie on their own side of the middle between
  /// both levels. However far it is beyond, a run counts as one. Of equal places the last: an outlier is a
  /// slow run more often than a fast one.
  void place() {
    for (std::size_t i = 0; i < cuts_.size(); ++i) {
      const Step s = step(i);
      const double middle = (s.before + s.after) / 2, half = (s.after - s.before) / 2;
      double sum = 0, least = 0;
      for (std::size_t run = before(i), to = after(i); run + 1 < to; ++run) {
        sum += std::clamp((raw_[run] - middle) / half, -kFull, kFull);
        if (sum <= least) least = sum, cuts_[i] = run + 1;
      }
    }
  }

  std::size_t before(std::size_t i) const { return i == 0 ? 0 : cuts_[i - 1]; }
  std::size_t after(std::size_t i) const { return i + 1 == cuts_.size() ? raw_.size() : cuts_[i + 1]; }

  double chance(std::size_t from, std::size_t cut, std::size_t to) const {
    return chance_of_difference(raw_.subspan(from, cut - from), raw_.subspan(cut, to - cut));
  }

  Step step(std::size_t i) const {
    const std::size_t from = before(i), cut = cuts_[i], to = after(i);
    return {cut, median(raw_.subspan(from, cut - from)), median(raw_.subspan(cut, to - cut)),
            chance(from, cut, to)};
  }

  Series raw_;
  std::vector<double> clipped_;
  StepRules rules_;
  std::vector<std::size_t> cuts_;  ///< rising
};

}  // namespace

std::vector<Step> find_steps(std::span<const double> series, const StepRules& rules) {
  return Search(series, rules).run();
}

}  // namespace halfway::statistics
