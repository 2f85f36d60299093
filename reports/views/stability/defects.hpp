// How the defects of each formulation grow with the relative rotation, for the report.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// Computed when asked, in a few seconds, at 50 digits, on generic linear/angular joints:
///   [{what (node_order, moment_balance), formulation, x [largest relative rotation of the
///   probes, rad], error [relative defect]}]
nlohmann::json stability_defects_record();

}  // namespace halfway::reports
