// Up to which rotation the energy of rod4 and rod34 is convex.
#pragma once

#include "halfway/joint/pose.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway {

/// |theta|, rad, below which 1/2 theta . K theta - 1/24 (w x theta) . K^-1 (w x theta), w = K theta, has a
/// positive definite Hessian whatever the direction; infinity where K is isotropic.
///
/// In principal axes the fourth order is -(g_1 y^2 z^2 + g_2 z^2 x^2 + g_3 x^2 y^2), g_i = (k_j - k_k)^2/(24
/// k_i). The Hessian is first singular on an axis i, where |theta|^2 = 12 k_j k_l/(k_i - k_j)^2, or within
/// the plane of two of them: of X = x^2, Y = y^2 on 12 g^2 X Y + 2 g (k_x X + k_y Y) = k_x k_y the least X +
/// Y. That no direction off the planes is worse is measured (verify), not proven.
/// @param k  principal values of K, N m/rad, > 0
inline double rod_convex_radius_of(const Vec3<double>& k) {
  double least = std::numeric_limits<double>::infinity();  // of |theta|^2
  for (int l = 0; l < 3; ++l) {
    const double kx = k[(l + 1) % 3], ky = k[(l + 2) % 3];
    const double g = (kx - ky) * (kx - ky) / (24 * k[l]);
    if (g == 0) continue;
    least = std::min({least, kx / (2 * g), ky / (2 * g)});
    // Stationary inside: Y = X + apart, a quadratic a X^2 + b X + c = 0 with both squares positive.
    const double apart = (ky - kx) / (6 * g);
    const double a = 12 * g * g, b = a * apart + 2 * g * (kx + ky), c = 2 * g * ky * apart - kx * ky;
    const double X = -2 * c / (b + std::sqrt(b * b - 4 * a * c));
    if (X > 0 && X + apart > 0) least = std::min(least, X + (X + apart));
  }
  return std::sqrt(least);
}

/// The same of a law's stiffness at no strain, n x n, n = 3 or 6 (translation first): where translations are
/// coupled to rotations and yield to them, a lower bound. 0 where the angular stiffness, or what the coupling
/// leaves of it, is not positive definite.
/// @tparam Matrix  of doubles; a template, so that what evaluates joints compiles no decomposition
template <class Matrix>
double rod_convex_radius(const Matrix& K) {
  const Mat3<double> angular = K.template bottomRightCorner<3, 3>();
  const Eigen::SelfAdjointEigenSolver<Mat3<double>> axes(angular);
  if (!(axes.eigenvalues()[0] > 0)) return 0;
  const double radius = rod_convex_radius_of(Vec3<double>(axes.eigenvalues()));
  if (K.rows() == 3 || K.template topRightCorner<3, 3>().isZero(0)) return radius;
  const Mat3<double> across = K.template topRightCorner<3, 3>();
  const Mat3<double> left =
      angular -
      across.transpose() * K.template topLeftCorner<3, 3>().completeOrthogonalDecomposition().solve(across);
  const Vec3<double> weight = axes.eigenvalues().cwiseSqrt().cwiseInverse();
  const Mat3<double> seen = weight.asDiagonal() * axes.eigenvectors().transpose() * left *
                            axes.eigenvectors() * weight.asDiagonal();
  const double share =
      Eigen::SelfAdjointEigenSolver<Mat3<double>>(seen, Eigen::EigenvaluesOnly).eigenvalues()[0];
  return share > 0 ? radius * std::sqrt(share) : 0;
}

}  // namespace halfway
