#include "reports/cli/run/page_data.hpp"

#include "reports/cli/run/comparison.hpp"
#include "reports/cli/run/run_files.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reports {
namespace {

/// Of a drawing: eight digits, and no rounding beside lengths of its size.
double shortened(double x, double size) {
  const double unit = std::pow(10, std::floor(std::log10(size)) - 8);
  return std::isfinite(x) && unit > 0 ? std::round(x / unit) * unit : x;
}

template <class V>
Json numbers(const V& v) {
  Json out = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) out.push_back(v[i]);
  return out;
}

template <class V>
Json short_numbers(const V& v) {
  const double size = v.size() == 0 ? 0 : v.cwiseAbs().maxCoeff();
  Json out = Json::array();
  for (Eigen::Index i = 0; i < v.size(); ++i)
    out.push_back(std::stod(fmt::format("{:.9g}", shortened(v[i], size))));
  return out;
}

Json quaternion_json(const Mat3<double>& R) {
  const auto q = so3::quaternion<double>(R);
  return short_numbers(Eigen::Vector4d(q.w, q.v[0], q.v[1], q.v[2]));
}

Json rows_json(const Eigen::MatrixXd& matrix) {
  Json rows = Json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) rows.push_back(numbers(Eigen::VectorXd(matrix.row(i))));
  return rows;
}

Json plain_law_json(const reference::LinearSpec& law) {
  return {{"type", law.is_compliance ? "compliance" : "stiffness"}, {"matrix", rows_json(law.matrix)}};
}

Json plain_law_json(const reference::PolynomialSpec& law) {
  return {{"type", "polynomial"}, {"k1", numbers(law.k1)}, {"k3", numbers(law.k3)}, {"k5", numbers(law.k5)}};
}

Json plain_law_json(const reference::PerAxisSpec& law) {
  Json knots = Json::array();
  for (const auto& axis : *law.axes) knots.push_back(axis.knots.size());
  return {{"type", "per_axis"}, {"knots", knots}};
}

Json law_json(const reference::LawSpec& law) {
  Json out = reference::visit_unshifted([](const auto& spec) { return plain_law_json(spec); }, law);
  if (const auto* shifted = std::get_if<reference::ShiftedSpec>(&law)) {
    out["offset"] = numbers(shifted->offset);
    out["preload"] = numbers(shifted->preload);
  }
  return out;
}

Json end_json(int body, const JointEnd<double>& end) {
  return {{"body", body}, {"o", vector_json(end.o)}, {"h", quaternion_json(end.H)}};
}

Json curve_json(const reference::SceneHead& scene, const reference::Curve& curve) {
  Json out = {{"label", curve_label(curve)},  {"formulation", curve.formulation},
              {"converged", curve.converged}, {"outcome", curve.outcome},
              {"cause", curve.cause},         {"rows", curve.rows},
              {"errors", curve.errors}};
  if (scene.critical_axis != 0 && curve.critical) out["critical_moment"] = double(curve.critical->moment);
  return out;
}

Json comparison_json(const std::vector<reference::Curve>& curves) {
  const Comparison found = compared(curves);
  Json groups = Json::array(), ended = Json::array();
  for (const auto& [members, answer, apart, error] : found.groups) {
    groups.push_back({{"curves", members}, {"answer", answer}, {"apart", apart}});
    groups.back()["error"] = error ? Json(*error) : Json(nullptr);
  }
  for (const auto& [cause, members] : found.ended) ended.push_back({{"cause", cause}, {"curves", members}});
  return {{"agree", kAgree},
          {"answers", found.answers},
          {"apart", found.apart},
          {"groups", groups},
          {"ended", ended}};
}

/// What holds each node there, (force, moment about it) of a, then of b, global axes: q = dU/dx.
Json held_by(const reference::Entry& entry, const reference::JointSpec& spec, const Pose<double>& b) {
  const auto q = reference::node_loads<double>(entry, spec, {}, b, false).q;
  return Json::array({load_numbers(q.head<6>()), load_numbers(q.tail<6>())});
}

/// Poses, and what holds the nodes, at each row of a curve.
void add_bodies(const reference::Scene& scene, const reference::Curve& curve, Json& out) {
  reference::JointSpec spec = scene.joint;
  spec.xi = curve.xi;
  const auto* entry = reference::find_formulation(curve.formulation);
  out["poses"] = out["holding"] = Json::array();
  for (const auto& b : curve.poses) {
    out["poses"].push_back(Json::array({pose_json({}), pose_json(b.front())}));
    if (entry) out["holding"].push_back(held_by(*entry, spec, b.front()));
  }
}

/// What each joint exerts on its two bodies at each row: the opposite of what holds them.
void add_reactions(const reference::Curve& curve, Json& out) {
  out["reactions"] = Json::array();
  for (const auto& row : curve.reactions) {
    Json joints = Json::array();
    for (const auto& loads : row)
      joints.push_back({load_numbers(loads.head<6>()), load_numbers(loads.tail<6>())});
    out["reactions"].push_back(joints);
  }
}

Json joint_json(const std::string& name, const reference::JointSpec& joint, int a, int b) {
  return {{"name", name},
          {"kind", to_string(joint.kind)},
          {"law", law_json(joint.law)},
          {"a", end_json(a, joint.a)},
          {"b", end_json(b, joint.b)}};
}

Json load_json(const reference::SceneLoad& load, int body) {
  return {{"body", body},
          {"type", reference::to_string(load.type)},
          {"value", vector_json(load.value)},
          {"point", vector_json(load.point)},
          {"held", load.held}};
}

Json motion_json(const reference::SceneMotion& motion) {
  Json out = {{"name", motion.name},
              {"body", motion.body},
              {"type", motion.is_rotation ? "rotation" : "displacement"},
              {"value", vector_json(motion.value)},
              {"point", vector_json(motion.point)}};
  if (motion.axis >= 0) out["axis"] = std::string(1, char('x' + motion.axis));
  return out;
}

}  // namespace

Json vector_json(const Vec3<double>& v) { return numbers(v); }

Json load_numbers(const Eigen::Matrix<double, 6, 1>& load) { return short_numbers(load); }

Json pose_json(const Pose<double>& pose) {
  Json out = short_numbers(pose.x);
  for (const auto& number : quaternion_json(pose.R)) out.push_back(number);
  return out;
}

Json page_head(const reference::SceneHead& scene, const Ran& ran) {
  Json out = {{"schema", "halfway-run-page"},
              {"version", 1},
              {"command", ran.command},
              {"scene",
               {{"name", scene.name},
                {"title", scene.title},
                {"description", scene.description},
                {"source", scene.source}}},
              {"notes", scene.notes},
              {"path", {{"factor_end", scene.factor_end}, {"points", scene.points}}}};
  if (scene.is_in_time) out["path"]["over"] = "time";
  if (scene.critical_axis != 0) out["critical_axis"] = scene.critical_axis;
  out["outputs"] = out["curves"] = out["left_out"] = Json::array();
  for (const auto& name : scene.outputs)
    out["outputs"].push_back({{"name", name}, {"unit", reference::unit_of_output(name)}});
  for (const auto& curve : ran.curves) out["curves"].push_back(curve_json(scene, curve));
  for (const auto& [name, reason] : ran.left_out)
    out["left_out"].push_back({{"formulation", name}, {"reason", reason}});
  out["comparison"] = comparison_json(ran.curves);
  return out;
}

Json page_data(const reference::Scene& scene, const Ran& ran) {
  Json out = page_head(scene, ran);
  const reference::JointSpec& joint = scene.joint;
  out["bodies"] =
      Json::array({{{"name", "a"}, {"clamped", true}, {"rest", pose_json({})}},
                   {{"name", "b"}, {"clamped", false}, {"rest", pose_json(reference::rest_pose(scene))}}});
  out["joints"] = Json::array({joint_json("joint", joint, 0, 1)});
  out["loads"] = Json::array();
  for (const auto& load : scene.loads) out["loads"].push_back(load_json(load, 1));
  for (std::size_t i = 0; i < ran.curves.size(); ++i) add_bodies(scene, ran.curves[i], out["curves"][i]);
  return out;
}

Json page_data(const reference::MechanismScene& scene, const Ran& ran) {
  Json out = page_head(scene, ran);
  out["bodies"] = out["joints"] = out["loads"] = Json::array();
  const auto rest = reference::initial_poses<double>(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const auto& body = scene.bodies[i];
    out["bodies"].push_back({{"name", body.name},
                             {"clamped", !body.moves},
                             {"rest", pose_json(rest[i].value_or(Pose<double>{}))}});
  }
  for (const auto& joint : scene.joints) {
    out["joints"].push_back(joint_json(joint.name, joint.spec, joint.a, joint.b));
    if (joint.damping.size() > 0) out["joints"].back()["damping"] = rows_json(joint.damping);
  }
  for (const auto& load : scene.loads) {
    out["loads"].push_back(load_json(load, load.body));
    if (load.times.empty()) continue;
    out["loads"].back()["times"] = load.times;
    out["loads"].back()["factors"] = load.factors;
  }
  out["motions"] = Json::array();
  for (const auto& motion : scene.motions) out["motions"].push_back(motion_json(motion));
  for (std::size_t i = 0; i < ran.curves.size(); ++i) {
    Json& curve = out["curves"][i];
    curve["poses"] = curve["holding"] = Json::array();
    for (const auto& row : ran.curves[i].poses) {
      Json poses = Json::array();
      for (const auto& pose : row) poses.push_back(pose_json(pose));
      curve["poses"].push_back(poses);
    }
    add_reactions(ran.curves[i], curve);
    if (scene.time) curve["energies"] = ran.curves[i].energies;
  }
  return out;
}

}  // namespace halfway::reports
