// What a check found, as text and verdict; and a room's checks run once, in a process apart, their records
// kept.
#pragma once

#include "verify/check.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace halfway::verify {

struct Record {
  std::string check;
  bool passed = false;
  std::string
      text{};  ///< a line of each finding, replays of what failed, measurements for ctest; or what went wrong
};

/// A finding in one line: verdict, name, value, unit, limits, oracle, where it was worst.
std::string line(const Finding& finding);

/// Runs the check here. One without findings, or that throws, has not passed.
Record record_of(const Check& check);

/// Runs the checks one after the other in a child process, so that what a study computes is computed once,
/// and hands on each record as it comes. A check that crashes, or is silent for `limit` seconds, has a record
/// that says so; the next ones run in another child.
void run_apart_each(const Checks& checks, int limit, const std::function<void(const Record&)>& take);

/// The records of a room in a file, a line of JSON each, there only once all of them are. Throws where the
/// file cannot be written.
void keep(const Checks& checks, int limit, const std::filesystem::path& file);

/// The kept record of a check. Throws where the file or the record is not there.
Record kept(const std::filesystem::path& file, const std::string& check);

}  // namespace halfway::verify
