// The circumstances of a measurement: without them a time means nothing.
#pragma once

#include "bench/harness/timing.hpp"

namespace halfway::bench {

/// Machine, compiler, flags, commit and build type of this executable; the date is now (UTC).
Context context();

}  // namespace halfway::bench
