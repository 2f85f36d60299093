// GSL's multidimensional root finder as the second, independent solver of equilibria.
#pragma once

#include <Eigen/Core>

#include <functional>
#include <string>

namespace halfway::reference {

struct GslOutcome {
  bool converged = false;
  Eigen::VectorXd x;
  int iterations = 0;
  std::string message;  ///< GSL's own words when it did not converge
};

/// Powell's hybrid method with finite-difference Jacobian (gsl_multiroot_fsolver_hybrids).
/// @param residual   r(x), as many components as x
/// @param tolerance  on the sum of |r_i|
GslOutcome gsl_hybrids(const std::function<Eigen::VectorXd(const Eigen::VectorXd&)>& residual,
                       const Eigen::VectorXd& start, double tolerance, int iterations = 200);

}  // namespace halfway::reference
