#include "bench/harness/slower.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

namespace halfway::bench {

std::optional<double> seeded_share() {
  const char* const set = std::getenv("HALFWAY_BENCH_SLOWER");
  if (set == nullptr) return std::nullopt;
  const std::string_view text(set);
  double share = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), share);
  if (error != std::errc() || end != text.data() + text.size() || !(share >= 0 && share <= 1))
    throw std::runtime_error(
        fmt::format("HALFWAY_BENCH_SLOWER: '{}' is not a share from 0 to 1, such as 0.10", text));
  return share;
}

void make_slower(Case& c, double share) {
  if (!c.evaluate) return;
  c.timed = [evaluate = c.evaluate, share](benchmark::State& state) {
    const auto n = state.max_iterations;
    const auto again = std::llround(share * double(n));
    while (state.KeepRunningBatch(n)) evaluate(int(n + again));
    state.counters["evaluated_again"] = double(again) / double(n);
  };
}

}  // namespace halfway::bench
