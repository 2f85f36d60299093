#include "reports/cli/errors.hpp"
#include "reports/history/store/digest.hpp"
#include "reports/history/store/rows.hpp"
#include "reports/history/store/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/Savepoint.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <unordered_map>

namespace halfway::history {
namespace {

using Places = std::unordered_map<int, int>;  ///< id in the file -> position in History

int place(const Places& places, int id, const char* what) {
  const auto found = places.find(id);
  if (found == places.end())
    throw std::invalid_argument(fmt::format("{} {} is named and not there", what, id));
  return found->second;
}

Places load_series(SQLite::Database& db, History& out, std::vector<int>& ids) {
  Places places;
  SQLite::Statement row(db,
                        "select series.id, cpu, cores, caches, microcode, compiler, flags, build_type, isa "
                        "from series join machine on machine.id = machine order by series.id");
  while (row.executeStep()) {
    places[ids.emplace_back(row.getColumn(0).getInt())] = int(out.series.size());
    const auto text = [&](int i) { return row.getColumn(i).getString(); };
    out.series.push_back({{text(1), row.getColumn(2), text(3), text(4)}, text(5), text(6), text(7), text(8)});
  }
  return places;
}

Places load_figures(SQLite::Database& db, History& out, std::vector<int>& ids) {
  Places places;
  SQLite::Statement row(db, "select id, name, unit, kind, better, formulation from figure order by id");
  while (row.executeStep()) {
    places[ids.emplace_back(row.getColumn(0).getInt())] = int(out.figures.size());
    Figure figure{.name = row.getColumn(1), .unit = row.getColumn(2)};
    from_string(row.getColumn(3).getString(), figure.kind);
    from_string(row.getColumn(4).getString(), figure.better);
    figure.formulation = row.getColumn(5).getString();
    out.figures.push_back(std::move(figure));
  }
  out.times.resize(out.figures.size()), out.changes.resize(out.figures.size());
  return places;
}

struct Sums {
  std::uint32_t run = 0, repetitions = 0;
};

/// With the checksums that were kept.
Places load_runs(SQLite::Database& db, const Places& series, History& out, std::vector<Sums>& kept) {
  Places places;
  SQLite::Statement row(
      db,
      "select id, series, \"commit\", date, dirty, title, release, load, libraries, checksum, "
      "repetition_checksum from run order by date, id");
  while (row.executeStep()) {
    places[row.getColumn(0)] = int(out.runs.size());
    out.runs.push_back({.id = row.getColumn(0),
                        .series = place(series, row.getColumn(1), "series"),
                        .commit = row.getColumn(2),
                        .dirty = row.getColumn(4).getInt() != 0,
                        .date = row.getColumn(3),
                        .title = row.getColumn(5),
                        .release = row.getColumn(6),
                        .load = row.getColumn(7).isNull() ? kNone : row.getColumn(7).getDouble(),
                        .libraries = row.getColumn(8)});
    seconds_of(out.runs.back().date);
    kept.push_back({row.getColumn(9).getUInt(), row.getColumn(10).getUInt()});
  }
  return places;
}

/// The runs whose content is not what was written.
std::string changed(const History& history, const std::vector<Sums>& kept, const std::vector<Digest>& runs,
                    const std::vector<Digest>& repetitions) {
  std::string out;
  int count = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const bool is_whole = kept[i].run == runs[i].value() && kept[i].repetitions == repetitions[i].value();
    if (is_whole || ++count > 3) continue;
    out +=
        fmt::format("{}run {} (commit {}, {}) is not what was written, by its checksum",
                    count > 1 ? "; " : "", history.runs[i].id, history.runs[i].commit, history.runs[i].date);
  }
  return count > 3 ? fmt::format("{}; and {} more", out, count - 3) : out;
}

}  // namespace

History Store::load() {
  series_ids_.clear(), figure_ids_.clear();
  SQLite::Savepoint one_moment(*db_, "load");  // others may write between two statements
  History out;
  std::vector<Sums> kept;
  std::string wrong;
  try {
    const Places series = load_series(*db_, out, series_ids_), figures = load_figures(*db_, out, figure_ids_);
    const Places runs = load_runs(*db_, series, out, kept);
    std::vector<std::uint32_t> names;
    for (const Figure& figure : out.figures) names.push_back(digest_of(figure));
    std::vector<Digest> sums(kept.size()), repetition_sums(kept.size());
    for (std::size_t i = 0; i < kept.size(); ++i) sums[i].run(out.runs[i], out.series[out.runs[i].series]);
    each_time(*db_, "", [&](int run, int figure, const Time& time) {
      const int r = place(runs, run, "run"), f = place(figures, figure, "figure");
      sums[r].time(names[f], time);
      out.times[f].push_back({r, time});
    });
    each_change(*db_, "", [&](int run, int figure, const Reading& reading) {
      const int r = place(runs, run, "run"), f = place(figures, figure, "figure");
      sums[r].change(names[f], reading);
      out.changes[f].push_back({r, reading});
    });
    each_repetition(*db_, "", [&](int run, int figure, const Repetitions& all) {
      const int r = place(runs, run, "run"), f = place(figures, figure, "figure");
      repetition_sums[r].repetitions(names[f], all);
      out.repetitions[{r, f}] = all;
    });
    wrong = changed(out, kept, sums, repetition_sums);
  } catch (const std::invalid_argument& error) {  // a word that no kind, verdict or date is
    damaged(error.what());
  }
  if (!wrong.empty()) damaged(wrong);
  one_moment.release();
  // Rows come by number, runs are ordered by date.
  for (auto& times : out.times) std::ranges::sort(times, {}, &TimeAt::run);
  for (auto& changes : out.changes) std::ranges::sort(changes, {}, &ReadingAt::run);
  return out;
}

}  // namespace halfway::history
