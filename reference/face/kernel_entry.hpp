// The kernel of a formulation behind a run-time face, with the loads of the readable transcription.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/numbers/precision.hpp"
#include "reference/numbers/random.hpp"

namespace halfway::reference {

/// Position (m) and unit quaternion (w, x, y, z) of a node: what kernels take.
template <class T>
struct QuaternionPose {
  Vec3<T> x = Vec3<T>::Zero();
  Eigen::Matrix<T, 4, 1> q{T(1), T(0), T(0), T(0)};
};

/// One kernel in scalar T; null where the formulation has none. The law must be a linear stiffness.
template <class T>
struct KernelEvaluators {
  AngularLoads<T> (*angular)(const JointSpec&, const QuaternionPose<T>& a, const QuaternionPose<T>& b,
                             bool with_tangent) = nullptr;
  NodeLoads<T> (*point)(const JointSpec&, const QuaternionPose<T>& a, const QuaternionPose<T>& b,
                        bool with_tangent) = nullptr;
};

struct KernelEntry {
  KernelEvaluators<double> in_double;
  KernelEvaluators<double> compensated;  ///< angular without ends alone: relative precision at any phi
  KernelEvaluators<float> in_float;      ///< with tangent alone
};

/// The same pose at 50 digits: the quaternion is normalised there.
Pose<Real50> exact_pose(const QuaternionPose<double>& p);

/// The same pose with a rotation matrix, rounded.
Pose<double> matrix_pose(const QuaternionPose<double>& p);

/// A joint frame that is generic and yet exact in double, as matrix and as quaternion: 120 degrees about
/// (1, sign, 1).
Mat3<double> third_of_turn(double sign);

/// Orientations of two nodes whose joint frames differ by phi (rad).
struct NodePair {
  Eigen::Matrix<double, 4, 1> a, b;
};
/// @param ends  third_of_turn(+1) and (-1) are the joint frames; else the nodes' own axes are
NodePair turned_pair(Generator& g, double phi, bool ends);

}  // namespace halfway::reference
