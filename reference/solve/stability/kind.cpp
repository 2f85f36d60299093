#include "reference/solve/stability/kind.hpp"

#include "reference/numbers/linear_algebra.hpp"
#include "reference/record/worst.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference {

const char* to_string(StabilityKind kind) {
  return kind == StabilityKind::stable       ? "stable"
         : kind == StabilityKind::divergence ? "divergence"
         : kind == StabilityKind::flutter    ? "flutter"
                                             : "unknown";
}

template <class T>
Characteristic<T> characteristic(const Mat3<T>& J, const BodyInertia& body, const Mat3<T>& R) {
  const Vec3<T> inverse = body.principal.cast<T>().cwiseInverse();
  const Mat3<T> axes = R * body.axes.cast<T>();
  const Mat3<T> A = axes * inverse.asDiagonal() * axes.transpose() * J;
  const T minors = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0) + A(1, 1) * A(2, 2) - A(1, 2) * A(2, 1) +
                   A(2, 2) * A(0, 0) - A(2, 0) * A(0, 2);
  return {A.trace(), minors, A.determinant()};
}

template Characteristic<double> characteristic(const Mat3<double>&, const BodyInertia&, const Mat3<double>&);
template Characteristic<Real50> characteristic(const Mat3<Real50>&, const BodyInertia&, const Mat3<Real50>&);

Eigen::MatrixXd mass_matrix(const BodyInertia& body, const Mat3<double>& R, int unknowns) {
  Eigen::MatrixXd M = body.mass * Eigen::MatrixXd::Identity(unknowns, unknowns);
  const Mat3<double> axes = R * body.axes;
  M.bottomRightCorner<3, 3>() = axes * body.principal.asDiagonal() * axes.transpose();
  return M;
}

std::vector<std::complex<double>> modes(const Eigen::MatrixXd& J, const Eigen::MatrixXd& M) {
  const Eigen::MatrixXd A = M.partialPivLu().solve(J);
  auto out = eigenvalues(A);
  if (out.empty()) out.assign(std::size_t(A.rows()), {std::nan(""), std::nan("")});
  std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) {
    return a.real() != b.real() ? a.real() < b.real() : a.imag() < b.imag();
  });
  return out;
}

StabilityKind stability_kind(const std::vector<std::complex<double>>& modes, double rounding) {
  double largest = 0, imaginary = 0;
  for (const auto& mu : modes) {
    keep_largest(largest, std::abs(mu));
    keep_largest(imaginary, std::abs(mu.imag()));
  }
  if (modes.empty() || std::isnan(largest)) return StabilityKind::unknown;
  if (imaginary > rounding * largest) return StabilityKind::flutter;
  return modes.front().real() > 0 ? StabilityKind::stable : StabilityKind::divergence;
}

}  // namespace halfway::reference
