// Branchings by the equations that define them, also where rounding has made them imperfect.
//
// With F = internal - applied and y = (pose, load factor), a branching is a point with F = 0 at which
// F_y loses a rank: psi^T F_y = 0, psi /= 0. That is one equation more than unknowns: any imbalance across
// the crossing paths, however small, parts them, and no point of either is singular. The defect beta in F +
// beta psi = 0 makes the system square and regular [Moore, SIAM J. Numer. Anal. 17 (1980)]. Its root is the
// branching of the problem without the defect, and beta says how much of one there is.
#pragma once

#include "reference/solve/paths/continuation_step.hpp"

#include <array>
#include <optional>

namespace halfway::reference {

struct DefinedBranching {
  ArcState<Real50> state{};
  double defect = 0;    ///< |psi^T F| for unit psi, over the stiffness at rest
  double rounding = 0;  ///< what rounding of the problem in double may leave of it, over the same
  double change = 0;    ///< length of the last correction, in the path's scales
  std::array<ArcVector<double>, 2> tangents{};  ///< unit, of the two paths
};

/// Newton from `start`, by tangents at 50 digits; nothing where it does not converge or no two paths cross.
std::optional<DefinedBranching> defined_branching(const ContinuationStep<Real50>& step,
                                                  const ArcState<Real50>& start);

}  // namespace halfway::reference
