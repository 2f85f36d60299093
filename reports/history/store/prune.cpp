#include "reports/history/store/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <set>
#include <vector>

namespace halfway::history {
namespace {

/// How many runs of its series come after each run.
std::vector<int> later_runs(const History& history) {
  std::vector<int> out(history.runs.size()), seen(history.series.size());
  for (int i = int(out.size()) - 1; i >= 0; --i) out[i] = seen[history.runs[i].series]++;
  return out;
}

}  // namespace

void Store::drop_repetitions(const History& history, int keep) {
  std::set<int> have;
  for (SQLite::Statement row(*db_, "select distinct run from repetition"); row.executeStep();)
    have.insert(row.getColumn(0).getInt());
  const std::vector<int> later = later_runs(history);
  for (std::size_t i = 0; i < later.size(); ++i) {
    const int id = history.runs[i].id;
    if (later[i] < keep || !have.contains(id)) continue;
    db_->exec(
        fmt::format("delete from repetition where run = {0}; update run set repetition_checksum = null "
                    "where id = {0}",
                    id));
  }
}

/// A run whose neighbour before it goes changes against the one before that now.
void Store::drop_runs(const History& history, int keep) {
  const std::vector<int> later = later_runs(history);
  const std::vector<Reading> nothing(history.figures.size(), Reading{.verdict = Verdict::gone});
  std::vector<std::vector<Reading>> last(history.series.size(), nothing);
  std::vector<bool> is_neighbour_gone(history.series.size());
  for (int i = 0; i < int(later.size()); ++i) {
    const Run& run = history.runs[i];
    if (later[i] >= keep && run.release.empty()) {
      for (const char* table : {"time", "change", "repetition"})
        db_->exec(fmt::format("delete from {} where run = {}", table, run.id));
      db_->exec(fmt::format("delete from run where id = {}", run.id));
      is_neighbour_gone[run.series] = true;
      continue;
    }
    const std::vector<Reading> is = readings_at(history, i);
    if (is_neighbour_gone[run.series]) {
      write_changes(run.id, last[run.series], is);
      write_digest(history, run);
    }
    last[run.series] = is, is_neighbour_gone[run.series] = false;
  }
}

void Store::prune(int runs, int repetitions) {
  {
    SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
    check_integrity();
    const History history = load();
    if (runs >= 0) drop_runs(history, runs);
    if (repetitions >= 0) drop_repetitions(history, repetitions);
    transaction.commit();
  }
  db_->exec("vacuum");
}

}  // namespace halfway::history
