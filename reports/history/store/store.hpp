// The file of the history: SQLite behind one class. What it reads is verified, what it writes is written
// whole or not at all.
#pragma once

#include "reports/history/record/history.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace SQLite {
class Database;
}

namespace halfway::history {

inline constexpr int kVersion = 2;               ///< of the schema: user_version
inline constexpr int kApplication = 0x48574179;  ///< "HWAy": application_id
inline constexpr int kRepetitionsKept = 20;      ///< runs of a series whose repetitions `add` keeps

/// Statements that bring a file from version i to version i + 1; the first makes a new one.
const std::string& migration(int from);

enum class Access { read, write };

class Store {
 public:
  /// Opens; with Access::write a file that is not there is made. A file of an earlier version is brought to
  /// this one. Throws reports::BadInput of a file that is not there, another program's, of a later version or
  /// damaged: nothing is written to it.
  Store(const std::filesystem::path& file, Access access);
  ~Store();

  /// Everything. Throws reports::BadInput that names the run whose checksum is wrong.
  History load();

  struct Outcome {
    int id = 0;
    bool was_there = false;  ///< the same run, already kept
  };
  /// Throws reports::BadInput when the same commit, date and series is there with other figures.
  Outcome add(const Record& record);

  /// Keeps the last `runs` of each series, those of releases, and repetitions of the last `repetitions`.
  /// Negative: all.
  void prune(int runs, int repetitions);

 private:
  void check_header() const;
  void migrate();
  void check_integrity();
  [[noreturn]] void damaged(const std::string& why) const;
  [[noreturn]] void newer(int version) const;

  int keep_series(History& history, const Series& series);
  bool keep_figures(History& history, const Record& record);
  void insert_run(const Run& run);
  void insert_times(const History& history, int id, const Record& record);
  void write_changes(int id, const std::vector<Reading>& from, const std::vector<Reading>& to);
  void write_digest(const History& history, const Run& run);
  void drop_repetitions(const History& history, int keep);
  void drop_runs(const History& history, int keep);

  std::filesystem::path file_;
  std::unique_ptr<SQLite::Database> db_;
  std::vector<int> series_ids_, figure_ids_;  ///< of what was loaded last, by position
};

/// Opens and does the work. What SQLite reports becomes one message that names the file: reports::BadInput
/// of a damaged file, reports::FailedRun of any other.
void with_store(const std::filesystem::path& file, Access access, const std::function<void(Store&)>& work);

}  // namespace halfway::history
