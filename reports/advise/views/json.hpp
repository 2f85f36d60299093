// An advice for programs.
#pragma once

#include "reports/advise/core/advice.hpp"

#include <nlohmann/json.hpp>

namespace halfway::advise {

/// {"schema": "halfway-advice-1", "scene", "tolerance", "truth", "advice", "candidates": [...], "margin",
/// ...}; what is no number is null. Of spreads the key is "distance", never "error".
nlohmann::ordered_json advice_json(const Advice& advice);

}  // namespace halfway::advise
