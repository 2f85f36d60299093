#include "reports/history/record/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace halfway::history {

std::vector<Reading> readings_at(const History& history, int run) {
  const int series = history.runs[run].series;
  std::vector<Reading> out(history.figures.size(), Reading{.verdict = Verdict::gone});
  for (std::size_t f = 0; f < out.size(); ++f) {
    for (const ReadingAt& change : history.changes[f]) {
      if (change.run > run) break;
      if (history.runs[change.run].series == series) out[f] = change.reading;
    }
  }
  return out;
}

int run_before(const History& history, int run) {
  for (int i = run - 1; i >= 0; --i)
    if (history.runs[i].series == history.runs[run].series) return i;
  return -1;
}

int run_after(const History& history, int run) {
  for (int i = run + 1; i < int(history.runs.size()); ++i)
    if (history.runs[i].series == history.runs[run].series) return i;
  return -1;
}

int find_run(const History& history, const std::string& text) {
  const int last = int(history.runs.size()) - 1;
  for (int i = last; i >= 0; --i)
    if (std::to_string(history.runs[i].id) == text) return i;
  for (int i = last; i >= 0; --i)
    if (history.runs[i].commit.starts_with(text)) return i;
  return -1;
}

Record record_at(const History& history, int run) {
  Record out{.run = history.runs[run], .series = history.series[history.runs[run].series]};
  const std::vector<Reading> readings = readings_at(history, run);
  for (std::size_t f = 0; f < history.figures.size(); ++f) {
    const Figure& figure = history.figures[f];
    if (readings[f].verdict != Verdict::gone) out.exact[figure.name] = {figure, readings[f]};
    const auto& times = history.times[f];
    const auto at = std::ranges::lower_bound(times, run, {}, &TimeAt::run);
    if (at == times.end() || at->run != run) continue;
    const auto kept = history.repetitions.find({run, int(f)});
    out.timed[figure.name] = {figure, at->time,
                              kept == history.repetitions.end() ? Repetitions{} : kept->second};
  }
  return out;
}

int HistoryBuilder::series_of(const Series& series) {
  const auto found = std::ranges::find(history.series, series);
  const int place = int(found - history.series.begin());
  if (found == history.series.end()) history.series.push_back(series), holds_.emplace_back();
  return place;
}

int HistoryBuilder::figure_of(const Figure& figure) {
  const auto [found, is_new] = places_.emplace(figure.name, int(history.figures.size()));
  if (is_new) {
    history.figures.push_back(figure);
    history.times.emplace_back(), history.changes.emplace_back();
  }
  history.figures[found->second] = figure;  // the latest description counts
  return found->second;
}

void HistoryBuilder::add(const Record& record) {
  const int at = int(history.runs.size());
  if (at > 0 && record.run.date < history.runs.back().date)
    throw std::invalid_argument(
        fmt::format("date {}: older than the run before it, {}; runs are by date (import takes any order)",
                    record.run.date, history.runs.back().date));
  const int series = series_of(record.series);
  Run& run = history.runs.emplace_back(record.run);
  run.id = at + 1, run.series = series;
  for (const auto& [name, timed] : record.timed) {
    const int f = figure_of(timed.figure);
    history.times[f].push_back({at, timed.time});
    if (!timed.repetitions.empty()) history.repetitions[{at, f}] = timed.repetitions;
  }
  const Reading gone{.verdict = Verdict::gone};
  std::vector<Reading> now;
  for (const auto& [name, exact] : record.exact) {
    const std::size_t f = std::size_t(figure_of(exact.figure));
    now.resize(std::max(now.size(), history.figures.size()), gone);
    now[f] = exact.reading;
  }
  now.resize(history.figures.size(), gone), holds_[series].resize(now.size(), gone);
  for (std::size_t f = 0; f < now.size(); ++f)
    if (!same(now[f], holds_[series][f])) history.changes[f].push_back({at, now[f]});
  holds_[series] = std::move(now);
}

}  // namespace halfway::history
