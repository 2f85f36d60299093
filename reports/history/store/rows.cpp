#include "reports/history/store/rows.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <charconv>
#include <stdexcept>

namespace halfway::history {
namespace {

double number(const SQLite::Column& column) { return column.isNull() ? kNone : column.getDouble(); }

Repetitions parse(const std::string& text) {
  Repetitions out;
  const char *at = text.data(), *const end = at + text.size();
  while (at < end) {
    const auto [next, error] = std::from_chars(at, end, out.emplace_back());
    if (error != std::errc() || (next != end && *next != ','))
      throw std::invalid_argument("repetitions: " + text);
    at = next + 1;
  }
  return out;
}

}  // namespace

void each_time(SQLite::Database& db, const std::string& where, const Sink<Time>& sink) {
  SQLite::Statement row(
      db, "select run, figure, median, low, high, n from time " + where + " order by run, figure");
  while (row.executeStep()) {
    const Time time{.median = row.getColumn(2).getInt64(),
                    .low = row.getColumn(3),
                    .high = row.getColumn(4),
                    .n = row.getColumn(5)};
    sink(row.getColumn(0), row.getColumn(1), time);
  }
}

void each_change(SQLite::Database& db, const std::string& where, const Sink<Reading>& sink) {
  SQLite::Statement row(
      db, "select run, figure, value, comparison, expected, low, high, verdict from change " + where +
              " order by run, figure");
  while (row.executeStep()) {
    Reading r{.value = number(row.getColumn(2)),
              .expected = number(row.getColumn(4)),
              .low = number(row.getColumn(5)),
              .high = number(row.getColumn(6))};
    from_string(row.getColumn(3).getString(), r.comparison);
    from_string(row.getColumn(7).getString(), r.verdict);
    sink(row.getColumn(0), row.getColumn(1), r);
  }
}

void each_repetition(SQLite::Database& db, const std::string& where, const Sink<Repetitions>& sink) {
  SQLite::Statement row(db, "select run, figure, ps from repetition " + where + " order by run, figure");
  while (row.executeStep()) sink(row.getColumn(0), row.getColumn(1), parse(row.getColumn(2).getString()));
}

}  // namespace halfway::history
