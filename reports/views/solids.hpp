// The 3D truth for the report: figures with error bars, convergence, curves.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// {"bodies": [...], "missing": [...]}; see SCHEMA.md, "solids". Kept data only: nothing is computed here.
nlohmann::json solids_record();

/// The 3D curves in the form of paper.reference_curves, so that they stand beside the lumped ones.
nlohmann::json solid_reference_curves();

}  // namespace halfway::reports
