// What the paper prints and what MBDyn gave, in the shape that the page reads (`paper` in reports/SCHEMA.md).
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// Table 1 cell by cell with its errata, the printed buckling moments, MBDyn's curves of Figs. 3 and 4.
/// Throws reference::DataError when a data file cannot be read or lacks a field.
nlohmann::json paper_record();

}  // namespace halfway::reports
