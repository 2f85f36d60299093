// Poses of nodes, the joint's ends on them, and their relative motion.
#pragma once

#include "halfway/rotations/so3.hpp"

namespace halfway {

/// What a joint strains: its relative rotation, its relative position, or both.
enum class Kind { angular, linear, linear_angular };

/// The name of a kind, the same in scenes, requests, tests and reports.
constexpr const char* to_string(Kind kind) {
  return kind == Kind::angular ? "angular" : kind == Kind::linear ? "linear" : "linear_angular";
}

/// Number of strains of a kind: 3, 3 or 6.
constexpr int strain_count(Kind kind) { return kind == Kind::linear_angular ? 6 : 3; }

template <class T, Kind kind>
using Strain = Eigen::Matrix<T, strain_count(kind), 1>;

/// Position (m, global axes) and orientation (node axes -> global axes) of a node.
template <class T>
struct Pose {
  Vec3<T> x = Vec3<T>::Zero();
  Mat3<T> R = Mat3<T>::Identity();
};

/// Joint point o (m) and joint frame H of one end, constant in the node's axes [8].
template <class T>
struct JointEnd {
  Vec3<T> o = Vec3<T>::Zero();
  Mat3<T> H = Mat3<T>::Identity();
};

/// The motion of joint frame b seen from joint frame a: p = P_a^T d [7], R = P_a^T P_b [4], and
/// theta = log R [5], all in the axes of P_a. An angular joint leaves p alone; a linear joint whose
/// law is fixed to node a leaves R, q and theta alone.
template <class T>
struct RelativeMotion {
  Vec3<T> p;
  Mat3<T> R;
  so3::Quaternion<T> q;
  Vec3<T> theta;
};

template <class T>
RelativeMotion<T> relative_motion(const Mat3<T>& R_ab, const Vec3<T>& p_ab_a) {
  RelativeMotion<T> m;
  m.p = p_ab_a;
  m.R = R_ab;
  m.q = so3::quaternion(R_ab);
  m.theta = so3::log(m.q);
  return m;
}

}  // namespace halfway
