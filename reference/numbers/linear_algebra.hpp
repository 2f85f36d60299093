// Decompositions of small matrices, compiled once: Eigen's own take seconds to compile, each time.
// Elimination in double and at 50 digits is Eigen's, the rest GSL's.
#pragma once

#include <Eigen/Core>

#include <array>
#include <complex>
#include <span>
#include <vector>

namespace halfway::reference {

/// Of any size up to 8, without the heap: unknowns of an equilibrium and what a path borders them with.
template <class T>
using SmallVector = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, 8, 1>;
template <class T>
using SmallMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;

/// By elimination with partial pivoting, of square matrices; not finite where one is singular. T is double or
/// Real50.
template <class T>
SmallMatrix<T> lu_solve(const SmallMatrix<T>& A, const SmallMatrix<T>& B);
template <class T>
SmallVector<T> lu_solve(const SmallMatrix<T>& A, const SmallVector<T>& b);
template <class T>
SmallMatrix<T> lu_inverse(const SmallMatrix<T>& A);
/// Of which the determinant is the product but for its sign, in the order of elimination.
template <class T>
SmallVector<T> lu_pivots(const SmallMatrix<T>& A);
template <class T>
T lu_determinant(const SmallMatrix<T>& A);

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
