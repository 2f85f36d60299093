// How well a joint represents the second-order couplings of a body.
#pragma once

#include "reference/truth/couplings.hpp"

namespace halfway::reference {

/// Which couplings are looked at: motion by the product of two loads.
enum class CouplingGroup {
  moments,  ///< rotations under two moments: all that an angular joint has
  forces,   ///< rotations under two forces: the bending of a compressed and sheared joint
  all       ///< every motion under every pair
};
inline constexpr CouplingGroup kCouplingGroups[] = {CouplingGroup::moments, CouplingGroup::forces,
                                                    CouplingGroup::all};
const char* to_string(CouplingGroup group);

/// |joint - truth| / |truth| over the group, each load and motion scaled by the square root of its own
/// block of the compliance C, which makes metres and radians comparable.
double coupling_error(const Couplings& joint, const Couplings& truth, const Eigen::Matrix<double, 6, 6>& C,
                      CouplingGroup group);

/// The xi of the intrinsic form that is nearest to the truth over the group, and what it leaves.
struct BestXi {
  double xi;
  double remainder;  ///< the group's coupling_error there: what no xi can represent
};

/// The intrinsic form's couplings are affine in xi, so the fit is a projection.
BestXi best_xi(const Couplings& truth, const Eigen::Matrix<double, 6, 6>& C, CouplingGroup group);

}  // namespace halfway::reference
