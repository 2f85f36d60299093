#include "reports/history/gate/side_report.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/history/gate/process.hpp"

#include <fmt/format.h>

namespace halfway::gate {
namespace {

namespace fs = std::filesystem;

constexpr double kLimit = 7200;  // s

fs::path suite_of(const Side& side, const fs::path& folder) {
  const fs::path beside = side.programs[0].parent_path(), build = beside.parent_path() / "build";
  if (fs::exists(beside / "halfway-suite")) return beside / "halfway-suite";
  if (!fs::exists(build / "build.ninja"))
    throw reports::FailedRun(
        fmt::format("--report: there is no halfway-suite beside {}", side.programs[0].string()));
  reports::tell(fmt::format("building the report of {}\n", side.name));
  const std::string failed = run({"ninja", "-C", build, "halfway_suite"}, folder / "suite.log", kLimit);
  if (!failed.empty())
    throw reports::FailedRun(fmt::format("building halfway_suite of {} {}", side.name, failed));
  return build / "bin/halfway-suite";
}

}  // namespace

Record side_report(const Side& side, const fs::path& folder) {
  const fs::path out = folder / "report", results = out / "results.json";
  if (side.commit.empty() || !fs::exists(results)) {
    fs::create_directories(folder);
    const fs::path suite = suite_of(side, folder);
    fs::remove(results);
    reports::tell(fmt::format("reporting on {}\n", side.name));
    // A report with failures ends with exit code 1, and is a report.
    const std::string failed = run({suite, "report", "--out", out}, folder / "report.log", kLimit);
    if (!fs::exists(results)) throw reports::FailedRun(fmt::format("the report of {} {}", side.name, failed));
  }
  Record record = read_report(out);
  record.name = side.name;
  return record;
}

}  // namespace halfway::gate
