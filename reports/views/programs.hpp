// Joints of other programs: how each law is known, what real programs answered, and its defects.
#pragma once

#include "reports/views/results.hpp"

namespace halfway::reports {

/// As `programs` of SCHEMA.md, measured ones first: sizes are those of the findings programs/..., cases what
/// the kept answers say of themselves. Empty where nothing of other programs was verified.
nlohmann::json programs_record(const std::vector<reference::Finding>& findings);

}  // namespace halfway::reports
