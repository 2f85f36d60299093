// Large rotation: who follows the rod. The object `rods` of results.json, see SCHEMA.md.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>

namespace halfway::reports {

/// @param progress  told after each part: done, of how many, which
nlohmann::json rods_record(const std::function<void(int, int, const std::string&)>& progress);

/// What stands beside the joints of C3, in the form of paper.reference_curves: its body by finite elements,
/// for the two laws that go farthest and the paper's, and the slender rod of its compliances.
nlohmann::json c3_reference_curves();

}  // namespace halfway::reports
