#include "verify/oracle/replay.hpp"

#include <nlohmann/json.hpp>

namespace halfway::verify {
namespace {

using nlohmann::json;

json json_of(const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); }

json json_of(const Mat3<double>& R) {
  const auto q = so3::quaternion<double>(R);
  return {q.w, q.v[0], q.v[1], q.v[2]};
}

json law_of(const reference::LawSpec& law) {
  if (const auto* p = std::get_if<reference::PolynomialSpec>(&law))
    return {{"type", "polynomial"}, {"k1", json_of(p->k1)}, {"k3", json_of(p->k3)}, {"k5", json_of(p->k5)}};
  const auto& linear = std::get<reference::LinearSpec>(law);
  Eigen::MatrixXd K = linear.matrix;
  if (linear.is_compliance) K = linear.matrix.inverse();
  json rows = json::array();
  for (Eigen::Index i = 0; i < K.rows(); ++i) rows.push_back(json_of(Eigen::VectorXd(K.row(i))));
  return {{"type", "linear"}, {"K", rows}};
}

json node_of(const Pose<double>& pose, const JointEnd<double>& end) {
  return {{"x", json_of(Eigen::VectorXd(pose.x))},
          {"q", json_of(pose.R)},
          {"o", json_of(Eigen::VectorXd(end.o))},
          {"h", json_of(end.H)}};
}

}  // namespace

std::string eval_request(const std::string& formulation, const reference::JointSpec& spec,
                         const Pose<double>& a, const Pose<double>& b) {
  json request = {{"formulation", formulation}, {"kind", to_string(spec.kind)},
                  {"law", law_of(spec.law)},    {"a", node_of(a, spec.a)},
                  {"b", node_of(b, spec.b)},    {"want", {"strain", "loads", "tangent", "energy"}}};
  const auto* entry = reference::find_formulation(formulation);
  if (entry != nullptr && entry->needs_xi) request["xi"] = spec.xi;
  return request.dump();
}

}  // namespace halfway::verify
