// Several equal joints one after the other where the scene has one: what one joint stands for in a coupling
// of several bushings.
#include "reference/scene/joint/free_strains.hpp"
#include "reference/solve/path.hpp"
#include "reference/solve/solve.hpp"
#include "reports/advise/truth/truth.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::advise {
namespace {

using reference::Scene;

/// A link: `joints` times as stiff, frames at its nodes, under a moment of its own.
Scene link_of(const Scene& scene, int joints) {
  Scene out = scene;
  auto law = std::get<reference::LinearSpec>(scene.joint.law);
  law.matrix *= law.is_compliance ? 1. / joints : joints;
  out.joint.law = law;
  out.joint.a = out.joint.b = {};
  out.loads.resize(1);
  return out;
}

/// The turn of all links, each by `invariant` in the frame of the one before: the moment is the same vector
/// in all.
/// @param moment  in the axes of the first, N m
/// @return  nothing where one of them has no equilibrium
std::optional<Mat3<double>> turned(const Scene& link, int joints, const Vec3<double>& moment) {
  Mat3<double> R = Mat3<double>::Identity();
  for (int i = 0; i < joints; ++i) {
    Scene own = link;
    own.loads.front().value = R.transpose() * moment;
    reference::Path<double> path(own, *reference::find_formulation("invariant"), 0.5);
    if (path.advance(1).status != Status::converged) return std::nullopt;
    R = R * path.node().R;
  }
  return R;
}

Answers answers_of(const Scene& scene, int joints, const std::vector<double>& factors) {
  const Scene link = link_of(scene, joints);
  Vec3<double> moment = Vec3<double>::Zero();
  for (const auto& load : scene.loads) moment += load.value;
  const Mat3<double>& H = scene.joint.a.H;
  const Pose<double> rest = reference::rest_pose(scene);
  Answers out{scene.outputs, factors, {}};
  for (const double factor : factors) {
    const auto R = turned(link, joints, H.transpose() * (factor * moment));
    if (!R) {
      out.ended = "a link of the chain has no equilibrium";
      return out;
    }
    const Mat3<double> turn = H * *R * H.transpose();
    const Vec3<double> theta = so3::log<double>(turn);
    std::vector<double> row;
    for (const std::string& output : scene.outputs) row.push_back(theta[output.back() - 'x']);
    out.value.push_back(std::move(row));
    out.node.push_back({rest.x, turn * rest.R});
  }
  return out;
}

}  // namespace

Truth chain_truth(const Scene& scene, int joints) {
  const auto refuse = [&](const char* why) {
    throw reports::BadInput(
        fmt::format("--truth chain:{}: scene {}: {}; a chain of joints stands for an angular joint with a "
                    "linear law, under "
                    "moments fixed in space",
                    joints, scene.name, why));
  };
  if (scene.joint.kind != Kind::angular) refuse("has another kind of joint");
  if (!std::holds_alternative<reference::LinearSpec>(scene.joint.law)) refuse("has a law that is not linear");
  const Eigen::MatrixXd K = reference::rest_stiffness(scene.joint.law, scene.joint.kind);
  if (K.size() > 0 && reference::free_strains(K).cols() > 0)
    refuse("has a law that is not positive definite");
  const auto is_fixed = [](const auto& load) {
    return load.type == reference::LoadType::fixed_moment && !load.held;
  };
  if (!std::ranges::all_of(scene.loads, is_fixed)) refuse("has another load");
  Truth out;
  out.kind = TruthKind::chain;
  out.scene = scene;
  out.described = fmt::format(
      "{} equal joints one after the other, each {} times as stiff and half-way (invariant)", joints, joints);
  out.at = [scene, joints](const std::vector<double>& factors) { return answers_of(scene, joints, factors); };
  return out;
}

}  // namespace halfway::advise
