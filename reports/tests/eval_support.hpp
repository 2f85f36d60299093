// Requests that the tests start from.
#pragma once

#include "reference/face/registry.hpp"

#include <nlohmann/json.hpp>

namespace halfway::reports::test {

/// A request without any symmetry: offsets, joint frames, anisotropic law; with xi where the
/// formulation needs one, and no coupling where it takes none. Wants everything.
nlohmann::json generic_request(const reference::Entry& entry, Kind kind);

inline constexpr Kind kKinds[] = {Kind::angular, Kind::linear, Kind::linear_angular};

/// eval_line, read back; fails the test when the answer is not one line of JSON.
nlohmann::json answer(const std::string& line);
inline nlohmann::json answer(const nlohmann::json& request) { return answer(request.dump()); }

/// Rows of numbers as a matrix, one number each as a column.
Eigen::MatrixXd matrix_of(const nlohmann::json& rows);
nlohmann::json json_of(const Eigen::MatrixXd& matrix);
nlohmann::json json_of(const Eigen::Vector3d& vector);

/// [w, x, y, z] of a rotation matrix, by Eigen.
nlohmann::json quaternion_of(const Eigen::Matrix3d& R);

}  // namespace halfway::reports::test
