// The joints and poses that are timed: fixed seed, no symmetry, every range of angle.
#pragma once

#include "reference/joint_spec.hpp"

#include <vector>

namespace halfway::bench {

/// One joint and the poses at which it is evaluated. Exact in double: the 50-digit check sees the
/// very same numbers.
struct Inputs {
  reference::JointSpec spec;  ///< linear law, N, m, rad; offsets and joint frames on both ends
  std::vector<Pose<double>> a, b;
};

/// Poses in one set: enough that no branch predictor learns them, few enough for the L2 cache.
inline constexpr int kPoses = 256;

/// Relative rotations log-uniform from 1e-3 to 3 rad in random directions, so that every branch of a
/// series or a quaternion is taken; full stiffness, coupled between translation and rotation unless
/// `block_diagonal`.
Inputs inputs(Kind kind, double xi, bool block_diagonal);

}  // namespace halfway::bench
