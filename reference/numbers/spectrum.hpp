// Eigenvalues by GSL: Eigen's own solver for matrices of any size takes eight seconds to compile.
#pragma once

#include <Eigen/Core>

namespace halfway::reference {

/// The smallest and the largest in magnitude, of a symmetric matrix of which the lower triangle is read;
/// NaN where an entry is not finite.
struct Spectrum {
  double smallest;
  double largest_magnitude;
};
Spectrum spectrum(const Eigen::MatrixXd& symmetric);

}  // namespace halfway::reference
