// What a run adds to the history: read from a report, the machine and git.
#pragma once

#include "reports/history/record/record.hpp"

#include <filesystem>
#include <optional>
#include <string>

namespace halfway::history {

struct Added {
  Record record;
  std::string note;  ///< what was left out and why; empty: nothing
};

/// results.json and bench.json (the latter may be missing: no repetitions then) in the folder of a report, or
/// a results.json alone. Throws reports::BadInput that names file and field.
Added read_report(const std::filesystem::path& path);

/// Repetitions of each benchmark, ps per joint or solve, and what Google Benchmark saw of the machine.
struct Bench {
  std::map<std::string, Repetitions> times;
  std::string caches;  ///< as caches_here() writes them
  double load = kNone;
};
/// Throws reports::BadInput.
Bench read_bench(const std::filesystem::path& file);

/// This machine: model, cores, caches, microcode and load of the last minute.
std::string cpu_here();
std::string caches_here();
std::string microcode_here();
std::string isa_here();
double load_here();

/// "L1d 48 KiB", in a list: one place that says how caches are written.
std::string cache_text(int level, const std::string& type, long bytes);

/// Versions of the libraries that this program's build found, JSON; of a report from the same build.
std::string libraries_here();

/// Subject of a commit of the repository that the working folder is in; empty: git or the commit is not
/// there.
std::string subject_of(const std::string& commit);

}  // namespace halfway::history
