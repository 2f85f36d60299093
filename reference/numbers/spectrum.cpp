#include "reference/numbers/spectrum.hpp"

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace halfway::reference {

Spectrum spectrum(const Eigen::MatrixXd& symmetric) {
  if (!symmetric.allFinite()) return {std::nan(""), std::nan("")};
  const auto n = std::size_t(symmetric.rows());
  // GSL destroys its argument, and reads the lower triangle of rows: the upper one of columns.
  Eigen::MatrixXd rows = symmetric.transpose();
  Eigen::VectorXd values(symmetric.rows());
  gsl_matrix_view matrix = gsl_matrix_view_array(rows.data(), n, n);
  gsl_vector_view out = gsl_vector_view_array(values.data(), n);
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> work(
      gsl_eigen_symm_alloc(n), &gsl_eigen_symm_free);
  gsl_eigen_symm(&matrix.matrix, &out.vector, work.get());
  return {values.minCoeff(), values.cwiseAbs().maxCoeff()};
}

}  // namespace halfway::reference
