// The cheapest sufficient model of each scene: what reaches a tolerance, and for how many nanoseconds.
#pragma once

#include "reports/views/results.hpp"

namespace halfway::reports {

/// Made by reports/advise/table. For each canonical scene of the results and each tolerance the choice of
/// least time, as in speed.cheapest[] of SCHEMA.md: what `halfway advise SCENE --truth form` answers with the
/// costs of these results. Empty without timings.
nlohmann::json cheapest(const Results& results);

}  // namespace halfway::reports
