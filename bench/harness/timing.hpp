// What a benchmark yields: a time and the error of what was timed, from the same run.
#pragma once

#include "bench/peak/peak.hpp"

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace halfway::bench {

/// What a time is of. The empty text and 0 mean: does not apply.
struct Label {
  std::string name;  ///< unique, e.g. invariant/angular/residual
  std::string formulation;
  std::string kind;  ///< angular, linear, linear_angular
  /// residual, residual_tangent, product (J v), assembly, equilibrium_newton, equilibrium_gsl,
  /// chain_iteration, chain_solution
  std::string what;
  /// reference (Eigen transcription), kernel, batch, assemble, chain, textbook, competitor
  std::string implementation = "reference";
  std::string precision = "double";  ///< double, float
  std::string isa;                   ///< instruction set of a batch: sse2, avx2, avx2vl, avx512
  std::string variant;  ///< approximation or extra of a kernel, e.g. order_2, log_10, compensated
  std::string method;   ///< of the tangent: analytic, dual, complex_step, forward, central, ...
  int joints = 0;       ///< in one call of a batch or assembly, or of a chain
  int threads = 0;      ///< that shared a batch
};

/// Worst error of the poses with phi in [from, to), rad.
struct ErrorAt {
  double from = 0, to = 0;
  double error = std::numeric_limits<double>::quiet_NaN();  ///< NaN: none was measured
};

struct Timing : Label {
  double ns = 0;      ///< CPU time (wall time of several threads) per evaluation (per solve for equilibria),
                      ///< median of repetitions
  double spread = 0;  ///< coefficient of variation of the repetitions
  double error = std::numeric_limits<double>::quiet_NaN();
  ///< worst error against 50 digits over the timed poses, relative to |K||strain|
  std::vector<ErrorAt> errors;  ///< the same by decade of phi, where the case measures it
  double flops = 0;             ///< of one evaluation, counted; 0: not counted
  double products = 0;          ///< multiplications among them
  double bytes = 0;             ///< read and written by one evaluation
  bool wrong = false;           ///< the check failed: there is no time
  std::string message;
};

/// Units that multiply do one multiply-add or one product at a time, and the peak is of multiply-adds alone:
/// the shortest time of so many products over the time they took. A compiler that finds some of them to be
/// one makes it look larger; stores, additions and divisions go elsewhere. NaN: nothing was counted.
inline double share_of_ports(const Timing& t, const Peak& peak) {
  return t.products > 0 ? 2 * t.products / peak.flops_per_ns / t.ns
                        : std::numeric_limits<double>::quiet_NaN();
}

struct Context {
  std::string machine, compiler, flags, commit, date, build_type;
};

struct Run {
  Context context;
  std::vector<Timing> timings;
  Peaks peaks;          ///< the larger of before and after the timings
  double parallel = 0;  ///< of two threads over one (parallel.hpp), the smaller of before and after
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
