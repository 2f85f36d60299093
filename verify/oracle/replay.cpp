#include "verify/oracle/replay.hpp"

#include <nlohmann/json.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace halfway::verify {
namespace {

using nlohmann::json;

json json_of(const Eigen::VectorXd& v) { return std::vector<double>(v.begin(), v.end()); }

json json_of(const Mat3<double>& R) {
  const auto q = so3::quaternion<double>(R);
  return {q.w, q.v[0], q.v[1], q.v[2]};
}

json rows_of(const Eigen::MatrixXd& m) {
  json rows = json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) rows.push_back(json_of(Eigen::VectorXd(m.row(i))));
  return rows;
}

/// The curve of one axis as scenes and requests spell it.
json axis_of(const reference::PiecewisePolynomial& curve) {
  const auto& c = curve.pieces.front();
  if (curve.knots.empty()) return {{"k1", c[1]}, {"k3", c[3]}, {"k5", c[5]}};
  if (curve.knots.size() == 1) return {{"negative", c[1]}, {"positive", curve.pieces.back()[1]}};
  constexpr const char* kMethods[] = {"linear", "akima", "monotone"};
  json y = json::array();
  for (std::size_t i = 1; i < curve.pieces.size(); ++i) y.push_back(curve.pieces[i][0]);
  return {{"x", curve.knots}, {"y", y}, {"interpolation", kMethods[int(curve.interpolation)]}};
}

struct PlainLaw {
  json operator()(const reference::LinearSpec& law) const {
    return {{"type", "linear"}, {law.is_compliance ? "compliance" : "stiffness", rows_of(law.matrix)}};
  }
  json operator()(const reference::PolynomialSpec& law) const {
    return {
        {"type", "polynomial"}, {"k1", json_of(law.k1)}, {"k3", json_of(law.k3)}, {"k5", json_of(law.k5)}};
  }
  json operator()(const reference::PerAxisSpec& law) const {
    json axes = json::array();
    for (const auto& curve : *law.axes) axes.push_back(axis_of(curve));
    return {{"type", "per_axis"}, {"axis", axes}};
  }
};

json law_of(const reference::LawSpec& law) {
  json out = visit_unshifted(PlainLaw{}, law);
  if (const auto* shifted = std::get_if<reference::ShiftedSpec>(&law)) {
    out["offset"] = json_of(shifted->offset);
    out["preload"] = json_of(shifted->preload);
  }
  return out;
}

json node_of(const Pose<double>& pose, const JointEnd<double>& end) {
  return {{"x", json_of(Eigen::VectorXd(pose.x))},
          {"q", json_of(pose.R)},
          {"o", json_of(Eigen::VectorXd(end.o))},
          {"h", json_of(end.H)}};
}

std::string row_of(const Eigen::VectorXd& v) {
  return fmt::format("[{}]", fmt::join(std::vector<double>(v.begin(), v.end()), ", "));
}

std::string frame_text(const Mat3<double>& R) {
  return fmt::format("[{}, {}, {}]", row_of(R.row(0)), row_of(R.row(1)), row_of(R.row(2)));
}

/// As values of TOML on one line.
std::string inline_toml(const json& value) {
  if (!value.is_structured()) return value.dump();
  std::string out;
  for (const auto& [key, item] : value.items())
    out += (out.empty() ? "" : ", ") + (value.is_object() ? key + " = " : "") + inline_toml(item);
  return value.is_object() ? "{ " + out + " }" : "[" + out + "]";
}

std::string law_text(const reference::LawSpec& law) {
  const json all = law_of(law);
  std::string out;
  for (const auto& [key, value] : all.items()) out += fmt::format("{} = {}\n", key, inline_toml(value));
  return out;
}

std::string load_text(const reference::SceneLoad& load) {
  std::string out =
      fmt::format("\n[[load]]\ntype = \"{}\"\nvalue = {}\n", to_string(load.type), row_of(load.value));
  if (is_force(load.type)) out += fmt::format("point = {}\n", row_of(load.point));
  if (load.type == reference::LoadType::quasi_tangential_moment)
    out += fmt::format("arm = {}\n", row_of(load.arm));
  return out + (load.held ? "held = true\n" : "");
}

std::string described(const reference::Setting& setting) {
  const bool is_moved = !setting.frame_turn.isZero(0) || !setting.frame_shift.isZero(0);
  const std::string order =
      setting.nodes_exchanged ? "it failed with the nodes exchanged" : "it failed as it is";
  if (!is_moved) return order;
  return fmt::format("{}, turned by {} rad and shifted by {} m as a whole", order, row_of(setting.frame_turn),
                     row_of(setting.frame_shift));
}

}  // namespace

std::string eval_request(const std::string& formulation, const reference::JointSpec& spec,
                         const Pose<double>& a, const Pose<double>& b) {
  json request = {{"formulation", formulation}, {"kind", to_string(spec.kind)},
                  {"law", law_of(spec.law)},    {"a", node_of(a, spec.a)},
                  {"b", node_of(b, spec.b)},    {"want", {"strain", "loads", "tangent", "energy"}}};
  const auto* entry = reference::find_formulation(formulation);
  if (entry != nullptr && entry->needs_xi) request["xi"] = spec.xi;
  if (entry != nullptr && entry->needs_length) request["length"] = spec.length, request["axis"] = spec.axis;
  return request.dump();
}

std::string scene_text(const reference::Scene& scene, const reference::Entry& entry, double xi,
                       const reference::Setting& setting) {
  const reference::JointSpec& joint = scene.joint;
  std::string out =
      fmt::format("title = \"{}\"\ndescription = \"{}\"\nformulations = [\"{}\"]\n",
                  scene.name.empty() ? "a failure" : scene.name, described(setting), entry.name);
  if (entry.needs_xi) out += fmt::format("xis = [{}]\n", xi);
  if (!scene.outputs.empty()) out += fmt::format("outputs = [\"{}\"]\n", fmt::join(scene.outputs, "\", \""));
  out += fmt::format("\n[joint]\nkind = \"{}\"\n", to_string(joint.kind));
  if (entry.needs_length) out += fmt::format("length = {}\naxis = {}\n", joint.length, joint.axis);
  for (const auto& [node, end] : {std::pair("a", &joint.a), std::pair("b", &joint.b)})
    out += fmt::format("offset_{0} = {1}\nframe_{0} = {2}\n", node, row_of(end->o), frame_text(end->H));
  out += "[joint.law]\n" + law_text(joint.law);
  for (const reference::SceneLoad& load : scene.loads) out += load_text(load);
  return out + fmt::format("\n[path]\nfactor_end = {}\npoints = {}\n", scene.factor_end, scene.points);
}

}  // namespace halfway::verify
