// The joints and poses that are timed: fixed seed, no symmetry, every range of angle.
#pragma once

#include "bench/harness/timing.hpp"
#include "reference/face/kernel_entry.hpp"

#include <vector>

namespace halfway::bench {

/// One joint and the poses at which it is evaluated. Exact in double: the 50-digit check sees the
/// very same numbers.
struct Inputs {
  reference::JointSpec spec;  ///< linear law, N, m, rad; offsets and joint frames on both ends
  std::vector<reference::QuaternionPose<double>> qa, qb;  ///< what kernels take
  std::vector<Pose<double>> a, b;                         ///< the same, rounded to matrices
};

/// Poses in one set: enough that no branch predictor learns them, few enough for the L2 cache.
inline constexpr int kPoses = 256;

/// Relative rotations log-uniform from 1e-3 to 3 rad in random directions, so that every branch of a
/// series or a quaternion is taken; full stiffness, coupled between translation and rotation unless
/// `block_diagonal`. Without `ends` the joint points and frames are at the nodes.
/// @param convex_radius  of a formulation whose energy is a series, of a stiffness: no rotation goes beyond,
/// where
///                       solvers refuse it and its terms cancel; nullptr: no limit
Inputs inputs(Kind kind, const Parameters& parameters, bool block_diagonal, bool ends = true,
              double (*convex_radius)(const Eigen::MatrixXd& K) = nullptr);

/// The ranges of the relative rotation angle (rad) in which errors are told apart: decades of phi from
/// 1e-12 to 1, [1, pi - 0.1), and decades of pi - phi from 0.1 to 1e-12.
std::vector<ErrorAt> phi_ranges();

/// The joint of `in` at kPosesInRange other poses with phi in the range, log-uniform in phi or in pi - phi.
Inputs moved_into(Inputs in, const ErrorAt& range);

inline constexpr int kPosesInRange = 8;

}  // namespace halfway::bench
