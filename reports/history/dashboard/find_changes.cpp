#include "reports/history/dashboard/dashboard.hpp"

#include "reports/history/record/exact.hpp"
#include "reports/history/statistics/changes.hpp"

#include <algorithm>
#include <span>

namespace halfway::history {
namespace {

using statistics::Exact;

/// Of the runs in which a figure was there, those of one series.
template <class Item>
std::vector<Item> of_series(const History& history, const std::vector<Item>& all, int series) {
  std::vector<Item> out;
  for (const Item& item : all)
    if (history.runs[item.run].series == series) out.push_back(item);
  return out;
}

void add(std::vector<Change>& out, const std::vector<statistics::Change>& found, const History& history,
         int figure, int series, const auto& runs) {
  const bool is_count = history.figures[figure].kind == Kind::count;
  for (const statistics::Change& c : found) {
    if (c.sense == statistics::Sense::change) continue;
    const bool is_regression = c.sense == statistics::Sense::regression;
    out.push_back({figure, series, runs[c.run].run, c.before, c.after, is_regression,
                   is_count ? c.after / c.before : c.ratio, c.digits, c.chance, c.text});
  }
}

}  // namespace

std::vector<Change> find_changes(const History& history) {
  std::vector<Change> out;
  for (int f = 0; f < int(history.figures.size()); ++f) {
    for (int s = 0; s < int(history.series.size()); ++s) {
      const auto times = of_series(history, history.times[f], s);
      std::vector<double> medians;
      for (const TimeAt& t : times) medians.push_back(t.time.ns());
      if (medians.size() > 1)
        add(out, statistics::find_changes(std::span<const double>(medians)), history, f, s, times);
      const auto changes = of_series(history, history.changes[f], s);
      std::vector<Exact> readings;
      for (const ReadingAt& c : changes) {
        const bool is_gone = c.reading.verdict == Verdict::gone && !readings.empty();
        readings.push_back(is_gone ? readings.back() : exact_of(history.figures[f], c.reading));
        if (is_gone) readings.back().value = readings.back().error = kNone;
      }
      if (readings.size() > 1)
        add(out, statistics::find_changes(std::span<const Exact>(readings)), history, f, s, changes);
    }
  }
  std::ranges::stable_sort(out, {}, &Change::run);
  return out;
}

}  // namespace halfway::history
