// The slender rod that a joint stands for, to all orders.
#include "reference/truth/rod/rod.hpp"
#include "reference/record/worst.hpp"
#include "reference/scene/joint/free_strains.hpp"
#include "reference/solve/solve.hpp"
#include "reports/advise/truth/truth.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/run/rod_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::advise {
namespace {

using reference::Scene;
using reports::BadInput;
namespace rod = reference::rod;

[[noreturn]] void refuse(const Scene& scene, const std::string& why) {
  throw BadInput(fmt::format("--truth rod: scene {}: {}", scene.name, why));
}

/// The curve of `run --rod`.
Answers angular_rod(const Scene& scene, const std::vector<double>& factors) {
  const reference::Curve curve = reports::rod_curve(scene, factors);
  Answers out{scene.outputs, factors, {}};
  for (std::size_t i = 0; i < factors.size(); ++i) {
    out.value.emplace_back(curve.rows[i].begin() + 1, curve.rows[i].end());
    out.node.push_back(curve.poses[i].front());
    reference::keep_largest(out.error, curve.errors[i]);
  }
  return out;
}

/// The rod of a linear/angular joint at its mid-length, see NOTATION, and where its ends are.
struct Slender {
  rod::Rod rod;
  Mat3<double> axes;  ///< of the rod -> joint
  Vec3<double> half;  ///< from the joint point to the tip, joint axes, m
};

Slender slender_of(const Scene& scene) {
  const reference::JointSpec& joint = scene.joint;
  const Eigen::MatrixXd K = reference::rest_stiffness(joint.law, joint.kind);
  const auto* law = std::get_if<reference::LinearSpec>(&joint.law);
  if (!law || !law->matrix.isDiagonal(0))
    refuse(scene, "a rod's stiffness is linear and diagonal in joint axes");
  Eigen::VectorXd k = law->matrix.diagonal();
  if (law->is_compliance) k = k.cwiseInverse().eval();
  if (!(k.minCoeff() > 0)) refuse(scene, "its stiffness is not positive definite");
  if (!scene.has_length)
    refuse(scene, "no joint.length: of a linear/angular joint the rod's length has to be known");
  const int along = int(std::abs(joint.axis)) - 1, second = (along + 1) % 3;
  Slender out;
  out.axes.col(0) = (joint.axis < 0 ? -1 : 1) * Vec3<double>::Unit(along);
  out.axes.col(1) = Vec3<double>::Unit(second);
  out.axes.col(2) = out.axes.col(0).cross(out.axes.col(1));
  const int third = 3 - along - second;
  const double L = joint.length;
  const Vec3<double> bending = L * Vec3<double>(k[3 + along], k[3 + second], k[3 + third]);
  // What a displacement across takes is bending about the other axis, and shear.
  const auto shear = [&](double across, double EI) { return (1 / across - L * L * L / (12 * EI)) / L; };
  out.rod.length = L;
  out.rod.section.bending = bending.cwiseInverse();
  out.rod.section.stretching = {1 / (L * k[along]), shear(k[second], bending[2]),
                                shear(k[third], bending[1])};
  if (!(out.rod.section.stretching.minCoeff() >= -1e-12 * out.rod.section.stretching.cwiseAbs().maxCoeff()))
    refuse(scene, "it is stiffer across than the bending of its length allows, 12 EI/L^3");
  out.rod.section.stretching = out.rod.section.stretching.cwiseMax(0);
  out.half = L / 2 * out.axes.col(0);
  return out;
}

/// At load factor 1, at the tip and in the axes of the rod at its clamp; of followers in those of the tip.
rod::Loads loads_of(const Scene& scene, const Slender& slender) {
  const auto& [a, b] = std::pair{scene.joint.a, scene.joint.b};
  const Mat3<double> fixed = (a.H * slender.axes).transpose(), following = (b.H * slender.axes).transpose();
  const Vec3<double> tip = b.o + b.H * slender.half;  // axes of node b
  rod::Loads out;
  for (const auto& load : scene.loads) {
    if (load.held) refuse(scene, "a load is held");
    if (is_force(load.type) && !(load.point - tip).isZero(1e-9 * scene.joint.length))
      refuse(scene, fmt::format(
                        "a force acts at [{}, {}, {}], not at the rod's end [{}, {}, {}] (axes of node b, m)",
                        load.point[0], load.point[1], load.point[2], tip[0], tip[1], tip[2]));
    switch (load.type) {
      case reference::LoadType::fixed_force:
        out.force += fixed * load.value;
        break;
      case reference::LoadType::fixed_moment:
        out.moment += fixed * load.value;
        break;
      case reference::LoadType::follower_force:
        out.follower_force += following * load.value;
        break;
      case reference::LoadType::follower_moment:
        out.follower_moment += following * load.value;
        break;
      default:
        refuse(scene, "a load is a pair of dead forces");
    }
  }
  return out;
}

Answers slender_rod(const Scene& scene, const std::vector<double>& factors) {
  const Slender slender = slender_of(scene);
  const rod::Loads loads = loads_of(scene, slender);
  const auto& a = scene.joint.a;
  const auto& b = scene.joint.b;
  const Mat3<double> root_axes = a.H * slender.axes;
  const Vec3<double> root = a.o - a.H * slender.half, tip_b = b.o + b.H * slender.half;
  const Pose<double> rest = reference::rest_pose(scene);
  Answers out{scene.outputs, factors, {}};
  for (const double factor : factors) {
    const rod::Tip tip = rod::solve(slender.rod, loads * factor);
    Pose<double> node;
    node.R = root_axes * tip.R * (b.H * slender.axes).transpose();
    node.x = root + root_axes * tip.x - node.R * tip_b;
    const Vec3<double> theta = so3::log<double>(node.R * rest.R.transpose()), u = node.x - rest.x;
    std::vector<double> row;
    for (const std::string& output : scene.outputs)
      row.push_back(output.starts_with("theta_") ? theta[output.back() - 'x'] : u[output.back() - 'x']);
    out.value.push_back(std::move(row));
    out.node.push_back(node);
    reference::keep_largest(out.error, tip.error * std::max(1., scene.joint.length));
  }
  return out;
}

}  // namespace

bool has_rod(const Scene& scene) {
  if (scene.joint.kind != Kind::linear_angular || !scene.has_length) return false;
  try {
    loads_of(scene, slender_of(scene));
    return true;
  } catch (const BadInput&) {
    return false;
  }
}

Truth rod_truth(const Scene& scene) {
  Truth out;
  out.kind = TruthKind::rod;
  out.scene = scene;
  out.described = "the slender rod of that stiffness, geometrically exact";
  if (scene.joint.kind == Kind::angular) {
    angular_rod(scene, {scene.factor_end});  // says what the scene is not, before the work
    out.at = [scene](const std::vector<double>& factors) { return angular_rod(scene, factors); };
  } else if (scene.joint.kind == Kind::linear_angular) {
    loads_of(scene, slender_of(scene));
    out.at = [scene](const std::vector<double>& factors) { return slender_rod(scene, factors); };
  } else {
    refuse(scene, "a joint that does not turn is no rod");
  }
  return out;
}

}  // namespace halfway::advise
