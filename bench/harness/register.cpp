// What Google Benchmark is told of: apart from the cases, whose checks others use without it.
#include "bench/harness/case.hpp"
#include "bench/harness/slower.hpp"

#include <utility>

namespace halfway::bench {
namespace {

void run_case(benchmark::State& state, const Case& c) {
  const Checked& check = checked(c);
  if (!check.message.empty()) {
    state.SkipWithError(check.message.c_str());
    return;
  }
  c.timed(state);
  using benchmark::Counter;
  state.counters["per_evaluation"] =
      Counter(c.evaluations, Counter::Flags(Counter::kIsIterationInvariantRate | Counter::kInvert));
  state.counters["max_error"] = check.error;
}

}  // namespace

void register_all() {
  static bool registered = false;
  if (std::exchange(registered, true)) return;
  const std::optional<double> share = seeded_share();
  Cases cases = all_cases();
  for (Case& c : cases) {
    if (share) make_slower(c, *share);
    auto* const b =
        benchmark::RegisterBenchmark(c.name.c_str(), [c](benchmark::State& state) { run_case(state, c); });
    if (c.wall_time) b->UseRealTime();
  }
}

}  // namespace halfway::bench
