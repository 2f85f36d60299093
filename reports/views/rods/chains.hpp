// Chains of joints in place of a rod. The object `rods.chains` of results.json, see SCHEMA.md.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

nlohmann::json chains_record();

}  // namespace halfway::reports
