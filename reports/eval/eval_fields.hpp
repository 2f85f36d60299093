// Typed access to the members of a request; every refusal names its field.
#pragma once

#include "reports/eval/eval_error.hpp"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reports {

/// A JSON value and where it stands in the line, e.g. a.q; an empty path is the line itself.
struct Field {
  const nlohmann::json& value;
  std::string path;
};

/// Refuses anything but an object with keys out of `allowed` (wrong_type, unknown_key).
void require_object(const Field& field, const std::vector<std::string_view>& allowed);

/// The member, if it is there.
std::optional<Field> member(const Field& object, std::string_view key);

/// The member; missing_key if it is not there.
Field required(const Field& object, std::string_view key);

/// @throws EvalError wrong_type
double number(const Field& field);
const std::string& text(const Field& field);

/// @throws EvalError wrong_type, wrong_shape
Eigen::VectorXd numbers(const Field& field, int count);
Eigen::MatrixXd square_matrix(const Field& field, int size);

}  // namespace halfway::reports
