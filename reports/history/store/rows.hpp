// Rows of the tables, in the order of their figures; `where` chooses them.
#pragma once

#include "reports/history/record/record.hpp"

#include <functional>
#include <string>

namespace SQLite {
class Database;
}

namespace halfway::history {

template <class Row>
using Sink = std::function<void(int run, int figure, const Row& row)>;

void each_time(SQLite::Database& db, const std::string& where, const Sink<Time>& sink);
void each_change(SQLite::Database& db, const std::string& where, const Sink<Reading>& sink);
void each_repetition(SQLite::Database& db, const std::string& where, const Sink<Repetitions>& sink);

}  // namespace halfway::history
