#include "reports/history/record/history.hpp"

#include <algorithm>

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

}  // namespace halfway::history
