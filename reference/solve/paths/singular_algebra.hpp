// Eigenvalues and null spaces of the small matrices of a path, by GSL.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <vector>

namespace halfway::reference {

/// Of a square matrix of any symmetry; empty where an entry is not finite.
std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& matrix);

/// The singular values of a matrix in descending order, and the right singular vectors (columns of `v`).
/// A matrix with fewer rows than columns counts as filled up with zero rows.
struct SingularValues {
  Eigen::VectorXd values;
  Eigen::MatrixXd v;
};
SingularValues singular_values(const Eigen::MatrixXd& matrix);

}  // namespace halfway::reference
