// All that a file keeps, in memory: runs by date, figures with what was kept of each.
#pragma once

#include "reports/history/record/record.hpp"

#include <map>
#include <utility>
#include <vector>

namespace halfway::history {

/// Runs and figures are named by their position in History.
struct TimeAt {
  int run = 0;
  Time time;
};

/// A deterministic figure that changed at this run: the reading holds for the later runs of its series.
struct ReadingAt {
  int run = 0;
  Reading reading;
};

struct History {
  std::vector<Series> series;
  std::vector<Run> runs;  ///< by date, then number
  std::vector<Figure> figures;
  std::vector<std::vector<TimeAt>> times;                    ///< of each figure, by run
  std::vector<std::vector<ReadingAt>> changes;               ///< the same
  std::map<std::pair<int, int>, Repetitions> repetitions{};  ///< of (run, figure); of the last runs only
};

/// Of each figure what holds at that run; Verdict::gone where it has no such figure.
std::vector<Reading> readings_at(const History& history, int run);

/// The run of its series before that one, or after; -1: none.
int run_before(const History& history, int run);
int run_after(const History& history, int run);

/// The run with this number, else the last one whose commit begins so, else, of an empty text, the last one;
/// -1: none.
int find_run(const History& history, const std::string& number_or_commit);

/// One run as it entered: every figure that it has.
Record record_at(const History& history, int run);

/// The way back: runs in the order of their dates, numbered from 1.
class HistoryBuilder {
 public:
  History history{};
  /// Throws std::invalid_argument of a run that is older than the one before it.
  void add(const Record& record);

 private:
  int series_of(const Series& series);
  int figure_of(const Figure& figure);
  std::map<std::string, int> places_{};        ///< of figures
  std::vector<std::vector<Reading>> holds_{};  ///< in each series, of each figure
};

}  // namespace halfway::history
