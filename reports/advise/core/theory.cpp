#include "reports/advise/core/theory.hpp"

#include "reference/scene/joint/free_strains.hpp"
#include "reference/truth/second_order.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace halfway::advise {
namespace {

using reference::Scene;

/// Orders go by |theta| k_max / k_min.
constexpr double kSmall = 0.25;

bool is_plain(const Scene& scene) {
  const auto is_fixed = [](const auto& load) {
    return load.type == reference::LoadType::fixed_moment && !load.held;
  };
  return scene.joint.kind == Kind::angular &&
         std::holds_alternative<reference::LinearSpec>(scene.joint.law) &&
         std::ranges::all_of(scene.loads, is_fixed);
}

}  // namespace

std::optional<double> second_order_error(const Truth& truth, const Candidate& c, double factor) {
  if (truth.kind != TruthKind::rod && truth.kind != TruthKind::chain) return std::nullopt;
  if (!is_plain(truth.scene) || (c.entry && !c.entry->facts.has_fingerprint)) return std::nullopt;
  const auto& law = std::get<reference::LinearSpec>(truth.scene.joint.law);
  const double beta = c.entry ? c.entry->facts.beta : 0;
  if (beta != 0 && !law.matrix.isDiagonal(0))
    return std::nullopt;  // Euler angles belong to the axes of the joint
  // A diagonal law keeps its axes: eigenvectors come in another order.
  const Mat3<double> M = law.matrix;
  Mat3<double> Q = Mat3<double>::Identity();
  Vec3<double> F = M.diagonal();
  if (!law.matrix.isDiagonal(0)) {
    const Eigen::SelfAdjointEigenSolver<Mat3<double>> principal(M);
    Q = principal.eigenvectors(), F = principal.eigenvalues();
    if (Q.determinant() < 0) Q.col(0) = -Q.col(0);
  }
  if (!law.is_compliance) F = F.cwiseInverse().eval();
  Vec3<double> moment = Vec3<double>::Zero();
  for (const auto& load : truth.scene.loads) moment += factor * load.value;
  const Vec3<double> m = Q.transpose() * (truth.scene.joint.a.H.transpose() * moment),
                     first = F.cwiseProduct(m);
  if (first.norm() == 0 || first.norm() * F.maxCoeff() / F.minCoeff() > kSmall) return std::nullopt;
  const Vec3<double> exact = reference::second_order_rotation<double>(F, m, 0.5, 0);
  if (!c.entry) return (first - exact).norm() / first.norm();
  const double alpha = c.entry->needs_xi ? c.xi : c.entry->facts.alpha;
  return (reference::second_order_rotation<double>(F, m, alpha, beta) - exact).norm() / first.norm();
}

}  // namespace halfway::advise
