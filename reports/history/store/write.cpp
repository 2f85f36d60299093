#include "reports/cli/errors.hpp"
#include "reports/history/store/digest.hpp"
#include "reports/history/store/rows.hpp"
#include "reports/history/store/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace halfway::history {
namespace {

template <class... Values>
void insert(SQLite::Database& db, const std::string& into, const Values&... values) {
  SQLite::Statement row(db, "insert into " + into);
  int i = 0;
  (row.bind(++i, values), ...);
  row.exec();
}

int last_id(const SQLite::Database& db) { return int(db.getLastInsertRowid()); }

/// NaN: null.
void bind_number(SQLite::Statement& row, int i, double x) {
  if (std::isnan(x))
    row.bind(i);
  else
    row.bind(i, x);
}

/// Is what was kept what this record says? A partial one says less.
bool same_content(const Record& kept, const Record& record) {
  if (!record.is_partial &&
      (kept.exact.size() != record.exact.size() || kept.timed.size() != record.timed.size()))
    return false;
  for (const auto& [name, exact] : record.exact) {
    const auto found = kept.exact.find(name);
    if (found == kept.exact.end() || !same(found->second.reading, exact.reading)) return false;
  }
  for (const auto& [name, timed] : record.timed) {
    const auto found = kept.timed.find(name);
    if (found == kept.timed.end() || found->second.time != timed.time) return false;
  }
  return true;
}

std::vector<Reading> nothing(const History& history) {
  return std::vector<Reading>(history.figures.size(), Reading{.verdict = Verdict::gone});
}

int find_same(const History& history, const Record& record) {
  for (std::size_t i = 0; i < history.runs.size(); ++i) {
    const Run& run = history.runs[i];
    if (run.commit == record.run.commit && run.date == record.run.date &&
        history.series[run.series] == record.series)
      return int(i);
  }
  return -1;
}

/// What holds after a run that came to `record` where `before` held.
std::vector<Reading> after(const History& history, std::vector<Reading> before, const Record& record) {
  for (std::size_t f = 0; f < history.figures.size(); ++f) {
    const auto found = record.exact.find(history.figures[f].name);
    if (found != record.exact.end())
      before[f] = found->second.reading;
    else if (!record.is_partial)
      before[f] = {.verdict = Verdict::gone};
  }
  return before;
}

}  // namespace

int Store::keep_series(History& history, const Series& s) {
  const auto found = std::ranges::find(history.series, s);
  if (found != history.series.end()) return int(found - history.series.begin());
  const Machine& m = s.machine;
  insert(*db_, "machine (cpu, cores, caches, microcode) values (?, ?, ?, ?)", m.cpu, m.cores, m.caches,
         m.microcode);
  insert(*db_, "series (machine, compiler, flags, build_type, isa) values (?, ?, ?, ?, ?)", last_id(*db_),
         s.compiler, s.flags, s.build_type, s.isa);
  series_ids_.push_back(last_id(*db_)), history.series.push_back(s);
  return int(history.series.size()) - 1;
}

/// Adds those that are new.
/// @return  was one described anew? Then the checksums of all that have it are.
bool Store::keep_figures(History& history, const Record& record) {
  std::unordered_map<std::string, std::size_t> places;
  for (std::size_t f = 0; f < history.figures.size(); ++f) places[history.figures[f].name] = f;
  bool is_anew = false;
  const auto keep = [&](const Figure& f) {
    const auto found = places.find(f.name);
    if (found == places.end()) {
      insert(*db_, "figure (name, unit, kind, better, formulation) values (?, ?, ?, ?, ?)", f.name, f.unit,
             to_string(f.kind), to_string(f.better), f.formulation);
      figure_ids_.push_back(last_id(*db_)), history.figures.push_back(f);
      history.times.emplace_back(), history.changes.emplace_back();
    } else if (Figure& old = history.figures[found->second]; old != f) {
      SQLite::Statement row(
          *db_, "update figure set unit = ?, kind = ?, better = ?, formulation = ? where name = ?");
      row.bind(1, f.unit), row.bind(2, to_string(f.kind)), row.bind(3, to_string(f.better));
      row.bind(4, f.formulation), row.bind(5, f.name);
      row.exec();
      old = f, is_anew = true;
    }
  };
  for (const auto& [name, exact] : record.exact) keep(exact.figure);
  for (const auto& [name, timed] : record.timed) keep(timed.figure);
  return is_anew;
}

void Store::insert_times(const History& history, int id, const Record& record) {
  for (std::size_t f = 0; f < history.figures.size(); ++f) {
    const auto found = record.timed.find(history.figures[f].name);
    if (found == record.timed.end()) continue;
    const Time& t = found->second.time;
    insert(*db_, "time values (?, ?, ?, ?, ?, ?)", id, figure_ids_[f], t.median, t.low, t.high, t.n);
    if (!found->second.repetitions.empty())
      insert(*db_, "repetition values (?, ?, ?)", id, figure_ids_[f],
             fmt::format("{}", fmt::join(found->second.repetitions, ",")));
  }
}

void Store::write_changes(int id, const std::vector<Reading>& from, const std::vector<Reading>& to) {
  db_->exec(fmt::format("delete from change where run = {}", id));
  SQLite::Statement row(*db_, "insert into change values (?, ?, ?, ?, ?, ?, ?, ?)");
  for (std::size_t f = 0; f < to.size(); ++f) {
    const Reading& r = to[f];
    if (same(from[f], r)) continue;
    row.bind(1, id), row.bind(2, figure_ids_[f]), row.bind(4, to_string(r.comparison));
    bind_number(row, 3, r.value), bind_number(row, 5, r.expected), bind_number(row, 6, r.low);
    bind_number(row, 7, r.high), row.bind(8, to_string(r.verdict));
    row.exec();
    row.reset();
  }
}

/// From the rows as they are now.
void Store::write_digest(const History& history, const Run& run) {
  Digest sum, repetitions;
  sum.run(run, history.series[run.series]);
  std::unordered_map<int, std::uint32_t> names;
  for (std::size_t f = 0; f < history.figures.size(); ++f)
    names[figure_ids_[f]] = digest_of(history.figures[f]);
  const std::string where = fmt::format("where run = {}", run.id);
  each_time(*db_, where, [&](int, int f, const Time& time) { sum.time(names.at(f), time); });
  each_change(*db_, where, [&](int, int f, const Reading& reading) { sum.change(names.at(f), reading); });
  each_repetition(*db_, where,
                  [&](int, int f, const Repetitions& all) { repetitions.repetitions(names.at(f), all); });
  SQLite::Statement row(*db_, "update run set checksum = ?, repetition_checksum = nullif(?, 0) where id = ?");
  row.bind(1, sum.value()), row.bind(2, repetitions.value()), row.bind(3, run.id);
  row.exec();
}

void Store::insert_run(const Run& run) {
  SQLite::Statement row(*db_, "insert into run values (?, ?, ?, ?, ?, ?, ?, 0, null, ?, ?)");
  row.bind(1, run.id), row.bind(2, series_ids_[run.series]), row.bind(3, run.commit), row.bind(4, run.date);
  row.bind(5, int(run.dirty)), bind_number(row, 6, run.load), row.bind(7, run.libraries);
  row.bind(8, run.title), row.bind(9, run.release);
  row.exec();
}

Store::Outcome Store::add(const Record& record) {
  SQLite::Transaction transaction(*db_, SQLite::TransactionBehavior::IMMEDIATE);
  check_integrity();
  History history = load();
  if (const int twin = find_same(history, record); twin >= 0) {
    const int id = history.runs[twin].id;
    if (same_content(record_at(history, twin), record)) return {id, true};
    throw reports::BadInput(
        fmt::format("{}: run {} is of the same commit {}, date {} and series, with other figures",
                    file_.string(), id, record.run.commit, record.run.date));
  }
  Run run = record.run;
  run.id = 1 + db_->execAndGet("select ifnull(max(id), 0) from run").getInt();
  run.series = keep_series(history, record.series);
  insert_run(run);
  const bool is_anew = keep_figures(history, record);
  insert_times(history, run.id, record);

  // Runs come in any order: the one after this one changes against this one now.
  const int place =
      int(std::ranges::upper_bound(history.runs, run.date, {}, &Run::date) - history.runs.begin());
  history.runs.insert(history.runs.begin() + place, run);
  for (auto& changes : history.changes)
    for (ReadingAt& change : changes) change.run += change.run >= place;
  const int before = run_before(history, place), next = run_after(history, place);
  const std::vector<Reading> was = before < 0 ? nothing(history) : readings_at(history, before);
  const std::vector<Reading> is = after(history, was, record);
  if (next >= 0) write_changes(history.runs[next].id, is, readings_at(history, next));
  write_changes(run.id, was, is);
  drop_repetitions(history, kRepetitionsKept);
  for (const Run& r : history.runs)
    if (is_anew || r.id == run.id || (next >= 0 && r.id == history.runs[next].id)) write_digest(history, r);
  transaction.commit();
  return {run.id, false};
}

}  // namespace halfway::history
