// What one process of a benchmark program measured.
#pragma once

#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace halfway::gate {

struct Timed {
  double ns = std::numeric_limits<double>::quiet_NaN();     ///< per evaluation, least of the repetitions
  double error = std::numeric_limits<double>::quiet_NaN();  ///< of what was timed; NaN: it tells none
  std::string wrong{};                                      ///< why there is no time
};
using Reading = std::map<std::string, Timed>;

struct BenchOptions {
  std::string filter;       ///< regular expression over names
  double min_time = 0.01;   ///< s per repetition
  int repetitions = 3;      ///< the least of them: what disturbs only adds
  double slower = -1;       ///< seeded slow-down, a share; negative: none, and nothing is set
  double time_limit = 600;  ///< s of one process
};

/// The rows of Google Benchmark's JSON that are no aggregates. Throws reports::FailedRun that names `what`.
Reading read_benchmarks(const std::string& text, const std::string& what);

/// Runs the program, which takes Google Benchmark's flags (halfway-suite: `bench` with its own), and leaves
/// its JSON and its log in the folder. Throws reports::FailedRun when it fails.
Reading measure(const std::filesystem::path& program, const BenchOptions& options,
                const std::filesystem::path& folder);

/// "^(a|b)$" with what means something in a regular expression escaped.
std::string filter_of(const std::vector<std::string>& names);

/// The dozen figures of the fast mode: transcriptions, kernels, batches and equilibria of several
/// formulations.
const std::vector<std::string>& fast_figures();

}  // namespace halfway::gate
