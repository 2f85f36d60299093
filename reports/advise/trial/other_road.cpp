#include "reports/advise/trial/other_road.hpp"

#include "reference/face/kernel_variants.hpp"
#include "reference/scene/joint/convexity.hpp"
#include "reference/scene/joint/free_strains.hpp"
#include "reference/solve/path.hpp"
#include "reference/truth/rod/rod.hpp"

#include <Eigen/Eigenvalues>

#include <stdexcept>

namespace halfway::advise {
namespace {

using reference::Scene;
namespace rod = reference::rod;

constexpr int kDegree = 40;  // of the polynomials: errors at rounding for a rod that turns by a radian

Mat3<double> stiffness_of(const Scene& scene) {
  const auto& law = std::get<reference::LinearSpec>(scene.joint.law);
  return law.is_compliance ? Mat3<double>(law.matrix.inverse()) : Mat3<double>(law.matrix);
}

Vec3<double> moment_of(const Scene& scene) {
  Vec3<double> out = Vec3<double>::Zero();
  for (const auto& load : scene.loads)
    if (!is_force(load.type)) out += load.value;
  return out;
}

std::vector<double> row_of_pose(const Scene& scene, const Vec3<double>& theta, const Vec3<double>& u) {
  std::vector<double> out;
  for (const std::string& output : scene.outputs)
    out.push_back(output.starts_with("theta_") ? theta[output.back() - 'x'] : u[output.back() - 'x']);
  return out;
}

/// The turn of the rod of an angular joint, in joint axes.
Mat3<double> rod_turn(const Mat3<double>& K, const Vec3<double>& moment) {
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> principal(K);
  Mat3<double> Q = principal.eigenvectors();
  if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
  rod::Loads loads;
  loads.moment = Q.transpose() * moment;
  const auto straight = rod::straight(1, rod::of_stiffness(principal.eigenvalues()));
  return Q * rod::collocate(straight, loads, kDegree).R * Q.transpose();
}

/// Of N links K N theta = exp(theta/2)^T (R^T m), the half-way law as it is printed.
Mat3<double> chain_turn(const Mat3<double>& K, const Vec3<double>& moment, int joints) {
  const Mat3<double> F = K.inverse() / joints;
  Mat3<double> R = Mat3<double>::Identity();
  for (int i = 0; i < joints; ++i) {
    const Vec3<double> m = R.transpose() * moment;
    Vec3<double> theta = F * m;
    for (int n = 0; n < 2000; ++n) {
      // Half of each step, so that what is stiff one way and soft another settles.
      const Vec3<double> next = F * (so3::exp<double>(theta / 2).transpose() * m);
      if ((next - theta).norm() <= 1e-15 * theta.norm()) break;
      theta += (next - theta) / 2;
    }
    R = R * so3::exp<double>(theta);
  }
  return R;
}

/// The slender rod of trial scenes: along axis 1, from node a to node b.
Answers slender_again(const Scene& scene, const std::vector<double>& factors) {
  const auto& law = std::get<reference::LinearSpec>(scene.joint.law);
  const Eigen::VectorXd k = law.matrix.diagonal();
  const double L = scene.joint.length;
  rod::Rod straight;
  straight.length = L;
  straight.section.bending = (L * k.tail<3>()).cwiseInverse();
  // Across, a fixed end takes L^3/12EI + L/GA.
  straight.section.stretching = {1 / (L * k[0]), (1 / k[1] - L * L / (12 * k[5])) / L,
                                 (1 / k[2] - L * L / (12 * k[4])) / L};
  Answers out{scene.outputs, factors, {}};
  for (const double factor : factors) {
    rod::Loads loads;
    for (const auto& load : scene.loads)
      (is_force(load.type) ? loads.force : loads.moment) += factor * load.value;
    const rod::Tip tip = rod::collocate(straight, loads, kDegree);
    out.value.push_back(row_of_pose(scene, so3::log<double>(tip.R), tip.x - L * Vec3<double>::UnitX()));
  }
  return out;
}

int joints_of_chain(const std::string& truth) { return std::stoi(truth.substr(6)); }

}  // namespace

Answers truth_again(const Advice& advice, const std::vector<double>& factors) {
  const Scene& scene = advice.truth.scene;
  if (!advice.truth.rows.empty()) return advice.truth.at(factors);
  if (scene.joint.kind != Kind::angular) return slender_again(scene, factors);
  const Mat3<double> K = stiffness_of(scene);
  const Mat3<double>& H = scene.joint.a.H;
  Answers out{scene.outputs, factors, {}};
  for (const double factor : factors) {
    const Vec3<double> m = H.transpose() * (factor * moment_of(scene));
    const Mat3<double> R = advice.truth.kind == TruthKind::chain
                               ? chain_turn(K, m, joints_of_chain(advice.question.truth))
                               : rod_turn(K, m);
    out.value.push_back(row_of_pose(scene, H * so3::log<double>(R), Vec3<double>::Zero()));
  }
  return out;
}

Answers model_again(const Scene& scene, const Candidate& c, const std::vector<double>& factors) {
  const std::optional<Scene> reduced = c.kind == scene.joint.kind ? scene : as_kind(scene, c.kind);
  const Scene& own = *reduced;
  Answers out{scene.outputs, factors, {}};
  const reference::Entry& any = c.entry ? *c.entry : reference::formulations().front();
  reference::Entry entry = reference::with_kernel(any, false);
  for (const auto& known : reference::invariant_variants())
    if (!c.variant.empty() && known.name == c.variant) entry = reference::with_variant(any, known);
  const reference::Setting turned{false, {0.3, -0.8, 0.5}, {0.1, 0.2, -0.3}};
  reference::Path<double> path(own, entry, c.xi, turned);
  const double radius = c.entry ? reference::convex_radius(*c.entry, own.joint) : 10;
  for (const double factor : factors) {
    if (c.entry) {
      const auto& state = path.advance(factor);
      if (!is_equilibrium(state.status)) break;
      if (so3::log(state.joint.R).norm() > radius) break;
    }
    std::vector<double> row;
    for (const std::string& output : scene.outputs) {
      const bool has = std::ranges::find(own.outputs, output) != own.outputs.end();
      row.push_back(!has ? 0 : c.entry ? path.output(output) : path.linear_output(output, factor));
    }
    out.value.push_back(std::move(row));
  }
  return out;
}

}  // namespace halfway::advise
