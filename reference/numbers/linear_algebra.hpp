// Decompositions of small matrices of any size by GSL: Eigen's own take eight seconds to compile, each time.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace halfway::reference {

/// The smallest and the largest in magnitude, of a symmetric matrix of which the lower triangle is read;
/// NaN where an entry is not finite.
struct Spectrum {
  double smallest;
  double largest_magnitude;
};
Spectrum spectrum(const Eigen::MatrixXd& symmetric);

/// Of a square matrix of any symmetry; empty where an entry is not finite.
std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& matrix);

/// The singular values of a matrix in descending order, and the right singular vectors (columns of `v`).
/// A matrix with fewer rows than columns counts as filled up with zero rows.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd v;
};
SingularValues singular_values(const Eigen::MatrixXd& matrix);

/// Of the straight line through points (x, y) by least squares; NaN where they have no two x.
double slope_of(std::span<const std::array<double, 2>> points);

}  // namespace halfway::reference
