// Large rotation: who follows the rod. The object `rods` of results.json, see SCHEMA.md.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace halfway::reports {

/// @param progress  told after each part: done, of how many, which
nlohmann::json rods_record(const std::function<void(int, int, const std::string&)>& progress);

/// The rod beside the scene of C3, in the form of paper.reference_curves.
nlohmann::json rod_reference_curve();

}  // namespace halfway::reports
