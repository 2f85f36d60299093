#include "reference/scene/joint/free_strains.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

/// A stiffness below this share of its block's largest is none.
constexpr double kNone = 1e-13;

template <int N>
Eigen::MatrixXd stiffness_of(const LawSpec& law) {
  return AnyLaw<double, N>(law)(Eigen::Matrix<double, N, 1>::Zero()).stiffness;
}

struct IsCompliance {
  bool operator()(const LinearSpec& law) const { return law.is_compliance; }
  bool operator()(const PolynomialSpec&) const { return false; }
  bool operator()(const PerAxisSpec&) const { return false; }
};

/// Is there an axis along which the strain has a component and the law a stiffness somewhere?
struct HasStiffness {
  const Eigen::VectorXd& strain;

  bool operator()(const LinearSpec&) const { return false; }
  bool operator()(const PolynomialSpec& law) const {
    return (strain.array() != 0 && (law.k3.array() != 0 || law.k5.array() != 0)).any();
  }
  bool operator()(const PerAxisSpec& law) const {
    for (Eigen::Index i = 0; i < strain.size(); ++i) {
      if (strain[i] != 0 && !is_flat((*law.axes)[std::size_t(i)])) return true;
    }
    return false;
  }
  /// The same stress everywhere.
  static bool is_flat(const PiecewisePolynomial& curve) {
    return std::ranges::all_of(curve.pieces, [](const PiecewisePolynomial::Piece& piece) {
      return std::all_of(piece.begin() + 1, piece.end(), [](double c) { return c == 0; });
    });
  }
};

}  // namespace

Eigen::MatrixXd rest_stiffness(const LawSpec& law, Kind kind) {
  if (visit_unshifted(IsCompliance{}, law)) return Eigen::MatrixXd(0, 0);
  return kind == Kind::linear_angular ? stiffness_of<6>(law) : stiffness_of<3>(law);
}

bool is_slack(const LawSpec& law, const Eigen::VectorXd& free_strain) {
  return visit_unshifted(HasStiffness{free_strain}, law);
}

std::optional<Corner> corner_near(const LawSpec& law, const Eigen::VectorXd& strain) {
  constexpr double kNear = 0.01;
  const auto* shifted = std::get_if<ShiftedSpec>(&law);
  const auto* curves = std::get_if<PerAxisSpec>(&law);
  if (shifted) curves = std::get_if<PerAxisSpec>(&shifted->law);
  for (Eigen::Index i = 0; curves && i < strain.size(); ++i) {
    const PiecewisePolynomial& curve = (*curves->axes)[std::size_t(i)];
    const double own = strain[i] - (shifted ? shifted->offset[i] : 0);
    for (std::size_t k = 0; k < curve.knots.size(); ++k) {
      const double knot = curve.knots[k];
      const double below = curve.on_piece(k, knot).slope, above = curve.on_piece(k + 1, knot).slope;
      const bool is_corner = std::abs(above - below) > 1e-9 * (std::abs(above) + std::abs(below));
      const double size = std::abs(curve.knots.back()) + std::abs(curve.knots.front());
      if (is_corner && std::abs(own - knot) <= kNear * (std::abs(knot) > 0 ? std::abs(knot) : size))
        return Corner{i, knot};
    }
  }
  return std::nullopt;
}

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
  Eigen::VectorXd scale = strain_units(K);
  for (Eigen::Index i = 0; i < K.rows(); ++i) {
    // Alone in its row it is no rounding of larger entries, however small.
    if (K(i, i) > 0 && K.row(i).cwiseAbs().sum() == K(i, i)) scale[i] = 1 / std::sqrt(K(i, i));
  }
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
