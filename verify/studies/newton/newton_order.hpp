// How fast plain Newton converges: the order and the factor of its errors, at 50 digits.
#pragma once

#include "verify/studies/newton/newton.hpp"

namespace halfway::reference {

/// The convergence of one run next to the equilibrium that it reached.
struct NewtonOrder {
  NewtonEnd end = NewtonEnd::too_many_iterations;
  int iterations = 0;
  double order = 0;      ///< slope of log e(k+1) over log e(k) in the last third; e = angle to the solution
  double factor = 0;     ///< geometric mean of e(k+1)/e(k) there: meaningful where the order is 1
  double predicted = 0;  ///< spectral radius of 1 - M^-1 J at the solution, M: what the run solves with there
  double asymmetry = 0;  ///< |J - J^T| / |J| at the solution
};

/// Errors down to 1e-44 are read, so that the 50 digits of the solution do not show.
/// order and factor are NaN where the run did not converge.
/// @param start   rotation vector of node b from the unstrained pose, scene axes, rad
NewtonOrder newton_order(const Scene& scene, const Entry& entry, NewtonTangent tangent, double factor,
                         const Vec3<double>& start);

/// c3_buckling's block under the fixed moment K theta: the linear analysis answers with theta, rad.
Scene block_scene(const Vec3<double>& linear_response);

/// A response of the block that is small enough for every tangent to converge, rad.
inline const Vec3<double> kSmallResponse{0.06, 0.05, 0.062};

/// Towards that response, from a little off rest: there some laws need one step. Computed once.
const NewtonOrder& block_order(const Entry& entry, NewtonTangent tangent);

/// The slope over the errors of several such runs at once, analytic tangent, starts 0.2 rad from rest: a
/// quadratic run has five errors at most, and the constant of its steps turns with their direction. NaN when
/// one of the runs does not converge. Computed once.
inline constexpr int kPooledRuns = 7;
double pooled_order(const Entry& entry);

}  // namespace halfway::reference
