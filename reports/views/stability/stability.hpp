// Where methods fail, and how: everything that the report's section on stability shows.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace halfway::reports {

/// {"paths", "kind", "range", "energy", "basins", "defects"}, each as its own header says; computed here.
/// @param progress  told (parts done, parts, name of the next part)
nlohmann::json stability_record(const std::function<void(int, int, const std::string&)>& progress);

}  // namespace halfway::reports
