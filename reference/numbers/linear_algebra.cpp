#include "reference/numbers/linear_algebra.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_fit.h>
#include <gsl/gsl_linalg.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace halfway::reference {
namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

gsl_matrix_view view(RowMajor& m) {
  return gsl_matrix_view_array(m.data(), std::size_t(m.rows()), std::size_t(m.cols()));
}

gsl_vector_view view(Eigen::VectorXd& v) { return gsl_vector_view_array(v.data(), std::size_t(v.size())); }

}  // namespace

Spectrum spectrum(const Eigen::MatrixXd& symmetric) {
  if (!symmetric.allFinite()) return {std::nan(""), std::nan("")};
  RowMajor destroyed = symmetric;
  Eigen::VectorXd values(symmetric.rows());
  gsl_matrix_view m = view(destroyed);
  gsl_vector_view out = view(values);
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> work(
      gsl_eigen_symm_alloc(std::size_t(values.size())), &gsl_eigen_symm_free);
  gsl_eigen_symm(&m.matrix, &out.vector, work.get());
  return {values.minCoeff(), values.cwiseAbs().maxCoeff()};
}

std::vector<std::complex<double>> eigenvalues(const Eigen::MatrixXd& matrix) {
  if (!matrix.allFinite()) return {};
  gsl_set_error_handler_off();
  const auto n = std::size_t(matrix.rows());
  RowMajor destroyed = matrix;
  gsl_matrix_view m = view(destroyed);
  std::vector<std::complex<double>> out(n);
  gsl_vector_complex_view values = gsl_vector_complex_view_array(reinterpret_cast<double*>(out.data()), n);
  const std::unique_ptr<gsl_eigen_nonsymm_workspace, decltype(&gsl_eigen_nonsymm_free)> work(
      gsl_eigen_nonsymm_alloc(n), &gsl_eigen_nonsymm_free);
  if (gsl_eigen_nonsymm(&m.matrix, &values.vector, work.get()) != GSL_SUCCESS) return {};
  return out;
}

SingularValues singular_values(const Eigen::MatrixXd& matrix) {
  gsl_set_error_handler_off();
  RowMajor u = RowMajor::Zero(std::max(matrix.rows(), matrix.cols()), matrix.cols());
  RowMajor v = RowMajor::Zero(matrix.cols(), matrix.cols());
  u.topRows(matrix.rows()) = matrix;
  SingularValues out{Eigen::VectorXd(matrix.cols()), {}};
  gsl_matrix_view u_view = view(u), v_view = view(v);
  gsl_vector_view values = view(out.values);
  gsl_linalg_SV_decomp_jacobi(&u_view.matrix, &v_view.matrix, &values.vector);
  out.v = v;
  return out;
}

double slope_of(std::span<const std::array<double, 2>> points) {
  if (points.size() < 2) return std::nan("");
  const double* const xy = points.front().data();
  double intercept, slope, variances[3], residual;
  gsl_fit_linear(xy, 2, xy + 1, 2, points.size(), &intercept, &slope, &variances[0], &variances[1],
                 &variances[2], &residual);
  return slope;
}

}  // namespace halfway::reference
