#include "reports/cli/run/rod_curve.hpp"

#include "reference/record/worst.hpp"
#include "reference/truth/rod/rod.hpp"
#include "reports/cli/errors.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>

namespace halfway::reports {
namespace {

using reference::Scene;

/// Principal values, ascending, and axes in those of the joint.
using Principal = Eigen::SelfAdjointEigenSolver<Mat3<double>>;

Principal principal_stiffness(const Scene& scene) {
  const auto refuse = [&](const char* what) {
    throw BadInput(
        fmt::format("--rod: scene {} {}; a rod stands for an angular joint with a linear law, under moments "
                    "fixed in space",
                    scene.name, what));
  };
  if (scene.joint.kind != Kind::angular) refuse("has another kind of joint");
  if (!std::holds_alternative<reference::LinearSpec>(scene.joint.law)) refuse("has a law that is not linear");
  const auto is_fixed = [](const auto& load) {
    return load.type == reference::LoadType::fixed_moment && !load.held;
  };
  if (!std::ranges::all_of(scene.loads, is_fixed)) refuse("has another load");
  const auto at_rest = reference::AnyLaw<double, 3>(scene.joint.law)(Vec3<double>::Zero());
  const Principal out(at_rest.stiffness);
  if (!(out.eigenvalues()[0] > 0)) refuse("has a law that is not positive definite");
  return out;
}

}  // namespace

reference::Curve rod_curve(const Scene& scene) {
  std::vector<double> factors;
  for (int i = 0; i <= scene.points; ++i) factors.push_back(scene.factor_end * i / scene.points);
  return rod_curve(scene, factors);
}

reference::Curve rod_curve(const Scene& scene, const std::vector<double>& factors) {
  const Principal law = principal_stiffness(scene);
  const Mat3<double> Q = scene.joint.a.H * law.eigenvectors();  // section -> scene
  Vec3<double> moment = Vec3<double>::Zero();
  for (const auto& load : scene.loads) moment += load.value;
  reference::Curve out = reference::empty_curve(scene, {nullptr, 0.5});
  out.formulation = "rod";
  const Pose<double> rest = reference::rest_pose(scene);
  const auto rod = reference::rod::straight(1, reference::rod::of_stiffness(law.eigenvalues()));
  // A left-handed set of axes names the same section: R = Q R' Q^T either way, with moments as axial vectors.
  const double hand = Q.determinant() < 0 ? -1 : 1;
  const auto tips = reference::rod::tips_under_moment(rod, hand * (Q.transpose() * moment), factors);
  for (std::size_t i = 0; i < factors.size(); ++i) {
    const Vec3<double> theta = so3::log<double>(Q * tips[i].R * Q.transpose());
    std::vector<double> row{factors[i]};
    for (const std::string& output : scene.outputs) row.push_back(theta[output.back() - 'x']);
    out.rows.push_back(std::move(row));
    out.errors.push_back(tips[i].error);
    out.poses.push_back({Pose<double>{rest.x, so3::exp<double>(theta) * rest.R}});
  }
  out.converged = true;
  out.outcome = "converged";
  return out;
}

}  // namespace halfway::reports
