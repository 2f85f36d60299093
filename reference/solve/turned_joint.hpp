// An angular joint seen from the joint frame of its clamped node, where its axes are those of the law: what a
// moment about a joint axis meets, wherever the nodes stand and however their frames are turned.
#pragma once

#include "reference/face/registry.hpp"

namespace halfway::reference {

/// All in the axes of the clamped node's joint frame.
template <class T>
struct TurnedJoint {
  Vec3<T> m;    ///< moment on the moving node, N m
  Mat3<T> m_w;  ///< its derivative by the spin of the moving node, N m/rad
  Mat3<T> R;    ///< orientation of the moving node
};

/// @param turn  rotation of the moving joint frame from the unstrained pose, where both frames are one.
/// @param nodes_exchanged  the clamped node, whose end is spec.a, is listed as b.
/// T is double or Real50.
template <class T>
TurnedJoint<T> turned_joint(const Entry& entry, const JointSpec& spec, const Mat3<T>& turn,
                            bool nodes_exchanged = false);

/// exp(angle e_axis). @param axis  0, 1 or 2. @param angle  rad
template <class T>
Mat3<T> about(int axis, const T& angle) {
  return so3::exp<T>(angle * Vec3<T>::Unit(axis));
}

}  // namespace halfway::reference
