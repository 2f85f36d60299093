// A slow-down that is really there, seeded to see whether the gate finds it. No normal run has one.
#pragma once

#include "bench/harness/case.hpp"

#include <optional>

namespace halfway::bench {

/// The environment's HALFWAY_BENCH_SLOWER, a share from 0 to 1 of evaluations made once more; nothing
/// where it is not set. Throws std::runtime_error on any other text.
std::optional<double> seeded_share();

/// Times the same evaluations and then `share` of them again, as if they were the first alone. Share 0 times
/// by the same road, to compare with. The counter `evaluated_again` tells the share that was reached. A case
/// without `evaluate` stays as it is and has no such counter.
void make_slower(Case& c, double share);

}  // namespace halfway::bench
