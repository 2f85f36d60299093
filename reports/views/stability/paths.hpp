// Equilibrium paths through buckling, by arc length, for the report.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// {"scene", "columns", "curves": [...], "steps": [...]}; see SCHEMA.md, "stability.paths": the paths of all
/// formulations through c3_buckling, skewed and without skew, which the findings are of.
nlohmann::json stability_paths_record();

}  // namespace halfway::reports
