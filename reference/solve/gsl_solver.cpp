#include "reference/solve/gsl_solver.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multiroots.h>

#include <memory>

namespace halfway::reference {
namespace {

using Residual = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

int call(const gsl_vector* x, void* residual, gsl_vector* r) {
  const auto& fn = *static_cast<const Residual*>(residual);
  Eigen::VectorXd at(x->size);
  for (std::size_t i = 0; i < x->size; ++i) at[i] = gsl_vector_get(x, i);
  const Eigen::VectorXd value = fn(at);
  for (std::size_t i = 0; i < x->size; ++i) {
    if (!std::isfinite(value[i])) return GSL_EBADFUNC;
    gsl_vector_set(r, i, value[i]);
  }
  return GSL_SUCCESS;
}

}  // namespace

GslOutcome gsl_hybrids(const Residual& residual, const Eigen::VectorXd& start, double tolerance,
                       int iterations) {
  gsl_set_error_handler_off();
  const std::size_t n = start.size();
  const std::unique_ptr<gsl_multiroot_fsolver, decltype(&gsl_multiroot_fsolver_free)> solver(
      gsl_multiroot_fsolver_alloc(gsl_multiroot_fsolver_hybrids, n), &gsl_multiroot_fsolver_free);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> x(gsl_vector_alloc(n), &gsl_vector_free);
  for (std::size_t i = 0; i < n; ++i) gsl_vector_set(x.get(), i, start[i]);
  gsl_multiroot_function function{&call, n, const_cast<Residual*>(&residual)};

  GslOutcome out;
  int status = gsl_multiroot_fsolver_set(solver.get(), &function, x.get());
  if (status == GSL_SUCCESS) status = gsl_multiroot_test_residual(solver->f, tolerance);
  while (status == GSL_CONTINUE && out.iterations < iterations) {
    ++out.iterations;
    status = gsl_multiroot_fsolver_iterate(solver.get());
    if (status == GSL_SUCCESS) status = gsl_multiroot_test_residual(solver->f, tolerance);
  }
  out.x.resize(n);
  for (std::size_t i = 0; i < n; ++i) out.x[i] = gsl_vector_get(solver->x, i);
  out.converged = status == GSL_SUCCESS;
  if (!out.converged) out.message = gsl_strerror(status);
  return out;
}

}  // namespace halfway::reference
