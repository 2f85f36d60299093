// Where a rotation measure has a pole, nobody evaluates it to eps.
#pragma once

#include "verify/probes.hpp"

namespace halfway::verify {

/// The largest condition number at which kernels and batches are held to their limits.
inline constexpr double kLargestCondition = 4;

/// Is d(angular strain)/d(spin) longer than kLargestCondition? Euler angles near their gimbal lock,
/// cayley's measure near pi; never for a linear joint. Dual numbers at 50 digits: no name is asked.
bool near_pole(const Entry& entry, const JointSpec& spec, const Pose<Real50>& a, const Pose<Real50>& b);

}  // namespace halfway::verify
