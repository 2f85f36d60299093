// Polynomials through Chebyshev's points of an interval, and their integrals.
#pragma once

#include <Eigen/Core>

namespace halfway::reference::rod {

/// Of the interval [0, 1].
struct ChebyshevRule {
  Eigen::VectorXd points;  ///< degree + 1 of them, ascending, both ends among them
  Eigen::MatrixXd
      integral;  ///< times values at the points: the integral of their polynomial from 0 to each point
};

/// @param degree  of the polynomials, 1 or more
ChebyshevRule chebyshev_rule(int degree);

}  // namespace halfway::reference::rod
