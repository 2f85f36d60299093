#include "bench/harness/case.hpp"

#include "bench/harness/slower.hpp"

#include <cmath>
#include <map>
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

const Checked& checked(const Case& c) {
  static std::map<std::string, Checked> done;
  const auto it = done.find(c.name);
  if (it != done.end()) return it->second;
  Checked out = c.check();
  if (out.message.empty() && !std::isfinite(out.error))
    out.message = "the check measured nothing, or no number";
  return done.emplace(c.name, std::move(out)).first->second;
}

void time_by(Case& c, std::function<void(int)> evaluate) {
  c.evaluate = evaluate;
  c.timed = [evaluate = std::move(evaluate)](benchmark::State& state) {
    for (auto _ : state) evaluate(1);
  };
}

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
