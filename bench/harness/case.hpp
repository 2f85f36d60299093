// A benchmark case: what is timed, and the check it has to pass first.
#pragma once

#include "bench/harness/timing.hpp"

#include <benchmark/benchmark.h>

#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace halfway::bench {

/// Outcome of the check: worst relative error, and what is wrong.
struct Checked {
  double error = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing was measured, which fails
  std::string message{};                                    ///< empty: passed
  std::vector<ErrorAt> errors{};
};

struct Case : Label {
  int evaluations = 1;                           ///< in one iteration of the timed loop
  double flops = 0;                              ///< of one evaluation, counted
  double products = 0;                           ///< multiplications among them
  double bytes = 0;                              ///< read and written by one evaluation
  bool wall_time = false;                        ///< and not CPU time: several threads share the work
  std::function<Checked()> check;                ///< run once, before the first timing
  std::function<std::vector<ErrorAt>()> errors;  ///< where the check has none: asked for by reports alone
  std::function<void(benchmark::State&)> timed;  ///< nothing but the timed loop
  std::function<void(int)> evaluate;             ///< what is timed, so many times over; may be empty
};

/// Times `evaluate`, whose argument is a number of iterations of Case::evaluations each: the call
/// costs some 2 ns an iteration, so it suits cases with many evaluations in one.
void time_by(Case& c, std::function<void(int)> evaluate);

using Cases = std::vector<Case>;

/// Every case of the suite: the catalog's order, then the equilibria.
Cases all_cases();

/// Registers them with Google Benchmark, once in a process. A case whose check fails is an error
/// row without a time.
void register_all();

/// The check of a case, made at the first call and kept.
const Checked& checked(const Case& c);

}  // namespace halfway::bench
