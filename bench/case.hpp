// A benchmark case: what is timed, and the check it has to pass first.
#pragma once

#include <benchmark/benchmark.h>

#include <functional>
#include <string>
#include <vector>

namespace halfway::bench {

/// Outcome of the check: worst relative error, and what is wrong.
struct Checked {
  double error = 0;
  std::string message;  ///< empty: passed
};

struct Case {
  std::string name;  ///< formulation/kind/what or scene/formulation/what
  std::string formulation;
  std::string kind;
  std::string what;
  int evaluations = 1;                           ///< in one iteration of the timed loop
  std::function<Checked()> check;                ///< run once, before the first timing
  std::function<void(benchmark::State&)> timed;  ///< nothing but the timed loop
};

using Cases = std::vector<Case>;

/// Every case of the suite: the catalog's order, then the equilibria.
Cases all_cases();

/// Registers them with Google Benchmark, once in a process. A case whose check fails is an error
/// row without a time.
void register_all();

/// The check of a case, made at the first call and kept.
const Checked& checked(const Case& c);

}  // namespace halfway::bench
