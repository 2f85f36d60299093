// Translation measures dbar = M(theta) p: the frame xi in which the relative position is seen.
//
// A translation offers motion(s), the isotropic function M; one that is also a frame offers
// rotation(m) = Q, frame xi seen from P_a (M = Q^T), and spin(m) = A, spin of Q = A psi [26]. kConstant:
// M is the identity at any theta; kFrame: it is a frame.
#pragma once

#include "halfway/joint/pose.hpp"

namespace halfway {

/// xi = 0: the joint frame of node a. M is the identity and nothing turns.
struct FrameA {
  static constexpr bool kConstant = true;
  static constexpr bool kFrame = true;
  template <class T>
  static Isotropic<T> motion(const T&) {
    return constant_isotropic<T>();
  }
  template <class T>
  static Mat3<T> rotation(const RelativeMotion<T>&) {
    return Mat3<T>::Identity();
  }
  template <class T>
  static Mat3<T> spin(const RelativeMotion<T>&) {
    return Mat3<T>::Zero();
  }
};

/// xi = 1: the joint frame of node b.
struct FrameB {
  static constexpr bool kConstant = false;
  static constexpr bool kFrame = true;
  template <class T>
  static Isotropic<T> motion(const T& s) {
    return so3::exp_isotropic(s, T(-1));
  }
  template <class T>
  static Mat3<T> rotation(const RelativeMotion<T>& m) {
    return m.R;
  }
  template <class T>
  static Mat3<T> spin(const RelativeMotion<T>&) {
    return Mat3<T>::Identity();
  }
};

/// xi = 1/2: half-way between the nodes; no trigonometric function [32, 71, 72].
struct FrameHalfway {
  static constexpr bool kConstant = false;
  static constexpr bool kFrame = true;
  template <class T>
  static Isotropic<T> motion(const T& s) {
    return so3::exp_isotropic(s, T(T(-1) / T(2)));
  }
  template <class T>
  static Mat3<T> rotation(const RelativeMotion<T>& m) {
    return so3::matrix(so3::half(m.q));
  }
  template <class T>
  static Mat3<T> spin(const RelativeMotion<T>& m) {
    const Vec3<T> z = m.q.v / (T(1) + m.q.w);  // tan(phi/4) n
    return (Mat3<T>::Identity() - skew(z)) / T(2);
  }
  /// d(A^T w)/d(psi) for constant w, 3x3: A^T = (1 + [z])/2 with z = tan(phi/4)/phi theta.
  template <class T>
  static Mat3<T> spin_transposed_rate(const RelativeMotion<T>& m, const Vec3<T>& w) {
    const T s = m.theta.squaredNorm();
    const Jet<T> tau = tangent_quotient(T(s / T(16)));
    const Jet<T> b{tau.f / T(4), tau.d1 / T(64), T(0)};
    const Isotropic<T> twice_At{b, {T(0), T(0), T(0)}};
    return twice_At.derivative(m.theta, w) * so3::gamma_inverse(m.theta) / T(2);
  }
};

/// Any real xi [10, 11, 20].
struct FrameWeighted {
  double xi = 0.5;
  static constexpr bool kConstant = false;
  static constexpr bool kFrame = true;
  template <class T>
  Isotropic<T> motion(const T& s) const {
    return so3::exp_isotropic(s, T(-xi));
  }
  template <class T>
  Mat3<T> rotation(const RelativeMotion<T>& m) const {
    return so3::exp<T>(T(xi) * m.theta);
  }
  template <class T>
  Mat3<T> spin(const RelativeMotion<T>& m) const {
    return T(xi) * so3::gamma<T>(T(xi) * m.theta) * so3::gamma_inverse(m.theta);
  }
};

/// Not a frame: v = Gamma(theta)^-1 p, the translation part of the logarithm on SE(3).
struct Se3Translation {
  static constexpr bool kConstant = false;
  static constexpr bool kFrame = false;
  template <class T>
  static Isotropic<T> motion(const T& s) {
    return so3::gamma_inverse_isotropic(s);
  }
};

}  // namespace halfway
