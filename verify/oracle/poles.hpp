// Where a rotation measure has a pole, nobody evaluates it to eps.
#pragma once

#include "verify/oracle/probes.hpp"

namespace halfway::verify {

/// Relative growth per rad of d(angular strain)/d(spin): a pose that is rounded by eps changes the tangent by
/// this many eps. Large near the gimbal lock of Euler angles and for cayley's measure near pi; 0 for a linear
/// joint; NaN at a pole. Dual numbers at 50 digits: no name is asked.
double steepness(const Entry& entry, const JointSpec& spec, const Pose<Real50>& a, const Pose<Real50>& b);

/// Kernels and batches are held to their limits up to here.
inline constexpr double kSteepest = 2.5;

}  // namespace halfway::verify
