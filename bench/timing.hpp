// What a benchmark yields: a time and the error of what was timed, from the same run.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace halfway::bench {

struct Timing {
  std::string name;  ///< e.g. invariant/angular/residual
  std::string formulation;
  std::string kind;    ///< angular, linear, linear_angular
  std::string what;    ///< residual, residual_tangent, equilibrium_newton, equilibrium_gsl
  double ns = 0;       ///< CPU time per evaluation (per solve for equilibria), median of repetitions
  double spread = 0;   ///< coefficient of variation of the repetitions
  double error = 0;    ///< worst error against 50 digits over the timed poses, relative to |K||strain|
  bool wrong = false;  ///< the check failed: there is no time
  std::string message;
};

struct Context {
  std::string machine, compiler, flags, commit, date, build_type;
};

struct Run {
  Context context;
  std::vector<Timing> timings;
};

struct Options {
  std::string json_file;     ///< native Google Benchmark output; empty: none
  std::string filter = ".";  ///< regular expression over names
  int repetitions = 5;
  double min_time = 0.02;  ///< s per repetition
};

/// Runs the benchmarks in this process; `progress(done, total, name)` is called after each.
Run run(const Options& options, const std::function<void(int, int, const std::string&)>& progress);

}  // namespace halfway::bench
