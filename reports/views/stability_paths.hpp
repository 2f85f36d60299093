// Equilibrium paths through buckling, by arc length, for the report.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// {"scene", "columns", "curves": [...], "steps": [...]}; see SCHEMA.md, "stability.paths". Computes the
/// paths of all formulations through c3_buckling, skewed and without skew: less than a second.
nlohmann::json stability_paths_record();

}  // namespace halfway::reports
