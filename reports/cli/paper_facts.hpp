// What the paper prints and what MBDyn gave, in the shape of results.json's "paper" (SCHEMA.md).
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// Throws reference::DataError when a data file cannot be read.
nlohmann::json paper_facts();

}  // namespace halfway::reports
