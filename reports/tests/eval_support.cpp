#include "reports/tests/eval_support.hpp"

#include "reports/eval/eval_line.hpp"

#include <boost/test/unit_test.hpp>

namespace halfway::reports::test {

using nlohmann::json;

json generic_request(const reference::Entry& entry, Kind kind) {
  const json K3 = {{4.0, 0.5, -0.25}, {0.5, 2.0, 0.75}, {-0.25, 0.75, 9.0}};
  json K = K3;
  if (kind == Kind::linear_angular) {
    Eigen::MatrixXd K6(6, 6);
    K6 << 30, 2, -1, 1, 0.5, -2, 2, 20, 3, 0.25, 1, 0.75, -1, 3, 10, -0.5, 1, 0.125, 1, 0.25, -0.5, 4, 0.5,
        -0.25, 0.5, 1, 1, 0.5, 2, 0.75, -2, 0.75, 0.125, -0.25, 0.75, 9;
    if (entry.block_diagonal_law_only) {
      K6.topRightCorner<3, 3>().setZero();
      K6.bottomLeftCorner<3, 3>().setZero();
    }
    K = json_of(K6);
  }
  // Unit quaternions that are rational: no rounding of the input is in the way.
  json request = {{"id", "generic"},
                  {"formulation", entry.name},
                  {"kind", to_string(kind)},
                  {"law", {{"type", "linear"}, {"K", K}}},
                  {"a",
                   {{"x", {0.25, -1.5, 0.75}},
                    {"q", {0.5, 0.5, -0.1, 0.7}},
                    {"o", {0.5, 0.125, -0.25}},
                    {"h", {0.8, 0.0, 0.6, 0.0}}}},
                  {"b",
                   {{"x", {0.5, -1.25, 1.5}},
                    {"q", {0.7, 0.5, 0.1, 0.5}},
                    {"o", {-0.375, 0.25, 0.5}},
                    {"h", {0.5, -0.5, 0.5, 0.5}}}},
                  {"want", {"strain", "loads", "tangent", "energy"}}};
  if (entry.needs_xi) request["xi"] = 0.25;
  if (entry.needs_length) request["length"] = 0.75, request["axis"] = -3;
  if (entry.convex_radius != nullptr) {  // half a radian, which its energy has to stand
    request["b"]["q"] = request["a"]["q"];
    request["b"]["h"] = {0.768, 0.224, 0.576, -0.168};
  }
  return request;
}

json answer(const std::string& line) {
  const std::string text = eval_line(line);
  BOOST_TEST(text.find('\n') == std::string::npos);
  json value = json::parse(text, nullptr, false);
  BOOST_REQUIRE_MESSAGE(value.is_object() && value.contains("id"), "not an answer: " << text.substr(0, 500));
  return value;
}

Eigen::MatrixXd matrix_of(const json& rows) {
  const bool is_column = rows.front().is_number();
  const auto width = Eigen::Index(is_column ? 1 : rows.front().size());
  Eigen::MatrixXd out(Eigen::Index(rows.size()), width);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    const json& row = rows[std::size_t(i)];
    for (Eigen::Index j = 0; j < width; ++j)
      out(i, j) = is_column ? row.get<double>() : row[std::size_t(j)].get<double>();
  }
  return out;
}

json json_of(const Eigen::MatrixXd& matrix) {
  json rows = json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    json row = json::array();
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) row.push_back(matrix(i, j));
    rows.push_back(row);
  }
  return rows;
}

json json_of(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

json quaternion_of(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q = Eigen::Quaterniond(R).normalized();
  return {q.w(), q.x(), q.y(), q.z()};
}

}  // namespace halfway::reports::test
