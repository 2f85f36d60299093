// The Euler-angle joints as mechanisms of pins and slides: three slides carry three pins, each with a spring.
//
// The angles of the pins are given and the poses follow from them, so no angle is ever read off a rotation;
// the moment follows from virtual work, by the axes of the pins in global axes. Nothing here calls the
// rotations or the measures of formulations/.
#pragma once

#include "reference/face/joint_spec.hpp"

#include <array>
#include <cmath>

namespace halfway::reference::pins {

/// A turn about one axis, by its definition.
template <class T>
Mat3<T> turn(int axis, const T& angle) {
  using std::cos, std::sin;
  Mat3<T> R = Mat3<T>::Identity();
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  R(j, j) = R(k, k) = cos(angle);
  R(j, k) = -sin(angle);
  R(k, j) = sin(angle);
  return R;
}

/// The axes of three pins in the order in which they follow each other from a to b.
using Order = std::array<int, 3>;

/// A chain from a's joint frame to b's, as it stands.
template <class T>
struct Chain {
  Mat3<T> P_a, P_b;
  Mat3<T> axes;  ///< of the pins in global axes; column i: the one that turns by e[i]
};

/// @param P_a  a's joint frame. @param e  angles by the index of their axis.
template <class T>
Chain<T> chain(const Mat3<T>& P_a, const Order& order, const Vec3<T>& e) {
  Chain<T> out{P_a, P_a, {}};
  for (const int i : order) {
    out.axes.col(i) = out.P_b.col(i);
    out.P_b = Mat3<T>(out.P_b * turn(i, e[i]));
  }
  return out;
}

/// Forces and torques of the springs.
template <class T>
struct Springs {
  Vec3<T> force, torque;
};

/// Springs on the slides and pins, coupled as the law says; what the kind has not carries nothing.
template <class T>
Springs<T> springs(const JointSpec& spec, const Vec3<T>& slide, const Vec3<T>& angle) {
  const auto& K = std::get<LinearSpec>(spec.law).matrix;
  Springs<T> out{Vec3<T>::Zero(), Vec3<T>::Zero()};
  const bool slides = spec.kind != Kind::angular, pins = spec.kind != Kind::linear;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      if (slides) out.force[i] += T(K(i, j)) * slide[j];
      if (pins) out.torque[i] += T(K(i + (slides ? 3 : 0), j + (slides ? 3 : 0))) * angle[j];
      if (!slides || !pins) continue;
      out.force[i] += T(K(i, j + 3)) * angle[j];
      out.torque[i] += T(K(i + 3, j)) * slide[j];
    }
  }
  return out;
}

/// The moment that does the work of the torques on the pins, M . axis_i = torque_i: by the dual axes.
template <class T>
Vec3<T> moment_of_pins(const Mat3<T>& axes, const Vec3<T>& torque) {
  const Vec3<T> x = axes.col(0), y = axes.col(1), z = axes.col(2);
  return (torque[0] * y.cross(z) + torque[1] * z.cross(x) + torque[2] * x.cross(y)) / x.dot(y.cross(z));
}

/// (f_a, m_a, f_b, m_b), conjugate to the motion of the nodes, of a force and a moment that b carries at
/// `point`.
template <class T>
Eigen::Matrix<T, 12, 1> at_nodes(const Vec3<T>& force, const Vec3<T>& moment, const Vec3<T>& point,
                                 const Vec3<T>& x_a, const Vec3<T>& x_b) {
  Eigen::Matrix<T, 12, 1> q;
  q << -force, -(moment + (point - x_a).cross(force)), force, moment + (point - x_b).cross(force);
  return q;
}

}  // namespace halfway::reference::pins
