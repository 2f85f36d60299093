// The exact figures of one run, as a comparison needs them: from a report or from the history.
#pragma once

#include "reports/history/gate/line.hpp"
#include "reports/history/record/record.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace halfway::gate {

struct Record {
  std::string name;  ///< as the caller named it
  std::string commit;
  std::string series;  ///< compiler, flags, build type, instruction set: exact values are compared within one
  std::string machine;                                 ///< its processor
  std::map<std::string, statistics::Exact> figures{};  ///< accuracy and counts
  bool is_partial = false;                             ///< of a quick report, or of one formulation
};

Record record_of(const history::Record& run, const std::string& name);

/// A results.json, or the folder of a report. Throws reports::BadInput that names the file and the field.
Record read_report(const std::filesystem::path& path);

/// Verdicts, limits, digits and counts; of another series verdicts and limits alone; counts within one
/// machine. A figure that is gone is a regression: nothing holds it any more. Times are not judged: two runs
/// apart differ by more than their repetitions do.
Outcome compare(const Record& before, const Record& after);

}  // namespace halfway::gate
