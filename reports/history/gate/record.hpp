// The figures of one run, as a comparison needs them: from a report's results.json or from the history.
#pragma once

#include "reports/history/gate/line.hpp"

#include <filesystem>
#include <map>
#include <string>

namespace halfway::gate {

struct Figure {
  statistics::Exact exact;  ///< of accuracy and counts
  double ns = 0;            ///< of a time; 0: it is none
};

struct Record {
  std::string name;  ///< as the caller named it
  std::string commit;
  std::string series;  ///< machine, compiler, flags, build type: exact values are compared within one
  std::map<std::string, Figure> figures;
};

/// A results.json, or the folder of a report. Throws reports::BadInput that names the file and the field.
Record read_report(const std::filesystem::path& path);

/// Verdicts, limits, digits and counts; of another series verdicts and limits alone. A figure that is gone is
/// a regression: nothing holds it any more. Times are not judged: two runs apart differ by more than their
/// repetitions do.
Outcome compare(const Record& before, const Record& after);

}  // namespace halfway::gate
