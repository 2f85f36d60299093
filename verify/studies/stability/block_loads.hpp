// Critical moments and modes of the block of C3 about its axes: computed once, judged and drawn.
#pragma once

#include "reference/solve/stability/critical.hpp"

#include <array>
#include <string>
#include <vector>

namespace halfway::verify {

/// Whose law it is.
inline constexpr const char* kBlockScene = "c3_buckling";

/// Flutter depends on the body, divergence does not.
inline const std::array<reference::BodyInertia, 2> kBlockBodies = {{{}, {"1:2:2.5", {1, 2, 2.5}, 1}}};
inline const reference::BodyInertia &kRound = kBlockBodies[0], &kLong = kBlockBodies[1];

inline constexpr reference::MomentSetting kFixed{reference::MomentType::fixed, false};

reference::JointSpec block_joint(const reference::Entry& entry);

/// @param axis  0, 1 or 2. @param body  one of kBlockBodies.
const reference::CriticalLoads& critical_loads(const reference::Entry& entry, int axis,
                                               const reference::MomentSetting& setting,
                                               const reference::BodyInertia& body);

/// The same for a check. Throws where the path ends as it begins: loads that are no number at the unstrained
/// pose would else pass for those of a joint that never becomes unstable.
const reference::CriticalLoads& begun_loads(const reference::Entry& entry, int axis,
                                            const reference::MomentSetting& setting,
                                            const reference::BodyInertia& body);

/// Of small motions round one state on the way there.
struct BlockModes {
  double load = 0, angle = 0;        ///< N m, rad
  double lowest = 0, imaginary = 0;  ///< smallest real part and largest imaginary one of mu, 1/s^2
  double growth = 0;                 ///< fastest, 1/s
};
BlockModes block_modes(const reference::Entry& entry, int axis, const reference::MomentSetting& setting,
                       const reference::BodyInertia& body, double angle);

/// About axis 0 with the round body, from rest to where the path or its load ends.
inline constexpr int kModesAxis = 0;
std::vector<BlockModes> modes_along(const reference::Entry& entry, const reference::MomentSetting& setting);

inline double relative(const reference::Real50& a, const reference::Real50& b) {
  return double(abs(a - b) / abs(b));
}

}  // namespace halfway::verify
