// Vectors in the kept data: lists of three numbers.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <nlohmann/json.hpp>

namespace halfway::reference::fe {

inline nlohmann::json triple(const Vec3<double>& v) { return {v[0], v[1], v[2]}; }

/// Throws nlohmann::json::exception unless the first three entries are numbers.
inline Vec3<double> vector(const nlohmann::json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

}  // namespace halfway::reference::fe
