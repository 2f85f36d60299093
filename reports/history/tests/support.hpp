// Runs without a report, and places for files that go when a test ends.
#pragma once

#include "reports/history/record/history.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace halfway::history::test {

class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

 private:
  std::filesystem::path folder_;
};

/// A name that means something to HTML, XML, CSV, JSON, regular expressions and SQL.
inline constexpr const char* kHostile = "<script>\"'&,\\]]>--\n{}';drop table run/angular/modelling_error";

/// Day i of a year, as a date.
std::string day(int i);

/// Figures e0, e1, ... with values of their own and times t0, t1, ...
Record record(int i, int exact = 5, int times = 3);

/// Bytes of a file.
std::string bytes_of(const std::filesystem::path& file);
void write_bytes(const std::filesystem::path& file, const std::string& bytes);

/// Adds them all.
void keep(const std::filesystem::path& file, const std::vector<Record>& records);
History load(const std::filesystem::path& file);
std::string exported(const std::filesystem::path& file);  ///< as JSON lines

/// What the work complains of; empty: nothing.
std::string complaint(const std::function<void()>& work);

}  // namespace halfway::history::test
