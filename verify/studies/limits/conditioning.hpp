// How many digits are lost, and to what: small rotations, stiffness ratios, drifted matrices, long arms.
// Each against the same input at 50 digits.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/numbers/counting.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

struct ErrorRow {
  std::string what{};  ///< series, e.g. "phi/double"
  std::string formulation{};
  double x = 0;        ///< what the series runs over
  double error = 0;    ///< of the loads or of the solution, relative; NaN where there is none
  std::string note{};  ///< why there is no error, or why it is not one of rounding
};
using ErrorRows = std::vector<ErrorRow>;

/// Symmetric, eigenvalues 1, sqrt(ratio), ratio N m/rad; `rotated`: about no axis of the frame.
Mat3<double> spread_stiffness(double ratio, bool rotated);

/// "phi/double", "phi/kernel", "phi/compensated" and "phi/float" over the relative rotation of nodes at
/// generic orientations, 1e-16 to 3 rad, of |K| phi; kernels where the formulation has them. The rounded
/// input is exact for both sides: what is lost is lost by the joint.
ErrorRows errors_over_phi(const Entry& entry);

/// "ratio_diagonal/loads", "ratio_rotated/loads" at 0.3 rad, and "ratio_diagonal/solve",
/// "ratio_rotated/solve": the rotation vector under a moment that turns the softest axis by 0.3 rad; over the
/// ratio, 1 to 1e8.
ErrorRows errors_over_ratio(const Entry& entry);

/// "singular/loads" of a stiffness with eigenvalues 1, 2 and x = 1e-14, 0, -1: loads need no inverse.
ErrorRows errors_at_bad_stiffness(const Entry& entry);

/// What the scene reader says to such a stiffness, without the file's place; empty: it accepts it.
std::string scene_refusal(const Mat3<double>& stiffness);

/// Node b's matrix is R + x E, |E| = 1, against the nearest rotation; at 50 digits, so drift alone is seen.
/// "drift/KIND" as it is, "drift_quaternion/KIND" after so3::matrix(so3::quaternion(R)), "drift_polar/KIND"
/// after one step (R + R^-T)/2.
ErrorRows errors_over_drift(const Entry& entry);

/// The flops of both projections.
struct ProjectionCost {
  OperationCount quaternion, polar;
};
ProjectionCost projection_cost();

/// Strain 0.1 m, over a length of 1e-9 to 1e9 m: "distance/KIND" of both nodes from the origin, arms of
/// 0.3 m; "offset/KIND" of both joint points from their nodes. KIND: linear, linear_angular. Forces over
/// |K| |strain|, moments over that with the arm; the worst of some poses of random orientation.
ErrorRows errors_over_distance(const Entry& entry);

/// One of the five above, measured once in a process.
const ErrorRows& errors(const Entry& entry, ErrorRows (*measure)(const Entry&));

}  // namespace halfway::reference
