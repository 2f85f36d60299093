// The JSON Schema of scene files, made of what their reader asks.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace halfway::reports {

/// Of what the reader asks while it reads the scenes of the sources: their keys, whether they are
/// needed, and what each may hold.
/// @param unseen  keys that are allowed and stand in none of them: anything goes there
nlohmann::ordered_json scene_schema(std::vector<std::string>& unseen);

}  // namespace halfway::reports
