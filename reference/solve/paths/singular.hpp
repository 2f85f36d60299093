// Singular points of a path, located at 50 digits: folds and simple branchings, told from poles and jumps. A
// branching whose paths are parted by no more than the rounding of the problem in double is one.
#pragma once

#include "reference/solve/paths/continuation_step.hpp"

namespace halfway::reference {

enum class Singularity {
  fold,      ///< the load factor turns back
  branching  ///< another path crosses this one
};
const char* to_string(Singularity singularity);

struct SingularPoint {
  Singularity type = Singularity::fold;
  ArcState<double> state{};
  double arc = 0;               ///< along the path, in its scales
  double phi = 0;               ///< rotation from rest, rad
  double located_to = 0;        ///< last change of the factor (relative) or of phi (rad), whichever is larger
  ArcVector<double> tangent{};  ///< of the path that was followed
  ArcVector<double> across{};   ///< of a branching: at right angles to it, in the plane of both paths
  bool simple = true;           ///< no further direction is singular
  double defect = 0;  ///< of a branching: the imbalance, over the stiffness at rest, that parts its paths
};

/// What a change of sign turned out to be.
enum class SignChange {
  zero,  ///< the singular point was found
  none,  ///< at 50 digits the sign does not change: it was rounding
  pole,  ///< through infinity
  jump   ///< no zero between the two points: they lie on different paths
};

struct Located {
  SignChange change = SignChange::jump;
  SingularPoint point{};
};

/// Looks for the singular point within `distance` ahead of `base`, which and whose end lie on a path.
/// @param tangent  unit tangent at base  @param end  the point at that distance, to be met again
Located locate(const ContinuationStep<Real50>& step, Singularity type, const ArcState<double>& base,
               const ArcVector<double>& tangent, double distance, const ArcState<double>& end);

}  // namespace halfway::reference
