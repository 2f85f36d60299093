#include "reference/scene/free_strains.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

/// A stiffness below this share of its block's largest is none.
constexpr double kNone = 1e-13;

/// A curve that is the same stress everywhere.
bool is_flat(const PiecewisePolynomial& curve) {
  return std::ranges::all_of(curve.pieces, [](const PiecewisePolynomial::Piece& piece) {
    return std::all_of(piece.begin() + 1, piece.end(), [](double c) { return c == 0; });
  });
}

/// Slopes at rest; those that are zero, of curves that are not, get their block's largest, or 1.
template <class IsFlat>
Eigen::MatrixXd diagonal_of(Eigen::VectorXd slopes, const IsFlat& is_flat_at) {
  for (Eigen::Index start = 0; start < slopes.size(); start += 3) {
    const double largest = slopes.segment<3>(start).maxCoeff();
    for (Eigen::Index i = start; i < start + 3; ++i) {
      if (slopes[i] == 0 && !is_flat_at(i)) slopes[i] = largest > 0 ? largest : 1;
    }
  }
  return slopes.asDiagonal();
}

struct RestStiffness {
  Eigen::MatrixXd operator()(const LinearSpec& law) const {
    return law.is_compliance ? Eigen::MatrixXd(0, 0) : law.matrix;
  }
  Eigen::MatrixXd operator()(const PolynomialSpec& law) const {
    return diagonal_of(law.k1, [&](Eigen::Index i) { return law.k3[i] == 0 && law.k5[i] == 0; });
  }
  Eigen::MatrixXd operator()(const PerAxisSpec& law) const {
    const auto& axes = *law.axes;
    Eigen::VectorXd slopes(Eigen::Index(axes.size()));
    for (std::size_t i = 0; i < axes.size(); ++i) slopes[Eigen::Index(i)] = axes[i].at(0.0).slope;
    return diagonal_of(slopes, [&](Eigen::Index i) { return is_flat(axes[std::size_t(i)]); });
  }
};

}  // namespace

Eigen::MatrixXd rest_stiffness(const LawSpec& law) { return visit_unshifted(RestStiffness{}, law); }

Eigen::VectorXd strain_units(const Eigen::MatrixXd& K) {
  Eigen::VectorXd out(K.rows());
  for (Eigen::Index i = 0; i < K.rows(); i += 3) {
    const double largest = K.diagonal().segment<3>(i).maxCoeff();
    out.segment<3>(i).setConstant(largest > 0 ? 1 / std::sqrt(largest) : 1);
  }
  return out;
}

Eigen::MatrixXd free_strains(const Eigen::MatrixXd& K) {
  if (K.size() == 0) return K;
  const Eigen::VectorXd scale = strain_units(K);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(scale.asDiagonal() * K * scale.asDiagonal());
  lu.setThreshold(kNone);
  if (lu.dimensionOfKernel() == 0) return Eigen::MatrixXd(K.rows(), 0);
  return scale.asDiagonal() * lu.kernel();
}

std::string strain_name(const Eigen::VectorXd& strain, Kind kind) {
  Eigen::Index i = 0;
  const double largest = strain.cwiseAbs().maxCoeff(&i);
  const Eigen::VectorXd n = (strain / (strain[i] < 0 ? -largest : largest)).array() + 0.0;  // no -0
  if (n.cwiseAbs().sum() > 1) return fmt::format("({:.3g}) in the joint's strains", fmt::join(n, ", "));
  const bool turns = kind == Kind::angular || i >= 3;
  return fmt::format("{} joint axis {}", turns ? "rotation about" : "translation along", i % 3 + 1);
}

}  // namespace halfway::reference
