// The cheapest sufficient model of each scene: what reaches a tolerance, and for how many nanoseconds.
#pragma once

#include "reports/views/results.hpp"

namespace halfway::reports {

/// For each canonical scene of the results and each tolerance the choice of least time, as in
/// speed.cheapest[] of SCHEMA.md. Scenes are solved again with every kernel that was timed, so that an
/// error is that of what was timed. Empty without timings.
nlohmann::json cheapest(const Results& results);

}  // namespace halfway::reports
