// Rotation measures e(R) [53 and formulations table], each with its rate and the rate's derivative.
//
// A measure offers, for a relative rotation and its left spin psi (delta R = [psi] R, axes of P_a):
//   strain(m)              e, 3 rad-like numbers
//   rate(m)                E, delta e = E psi, 3x3
//   transport_rate(m, mu)  d(E^T mu)/d(psi) for constant mu, 3x3
// With E^T the stress mu becomes the moment conjugate to the spin.
#pragma once

#include "halfway/joint/pose.hpp"

namespace halfway {

/// Moment conjugate to the spin from the gradient g in theta: Gamma^-T g; and its spin derivative
/// when g itself has the (symmetric) gradient `hessian`.
template <class T>
Mat3<T> spin_derivative(const Vec3<T>& theta, const Vec3<T>& g, const Mat3<T>& hessian) {
  const Isotropic<T> inverse = so3::gamma_inverse_isotropic(T(theta.squaredNorm()));
  const Isotropic<T> transposed = inverse.transposed();
  return (transposed.derivative(theta, g) + transposed.matrix(theta) * hessian) * inverse.matrix(theta);
}

/// Measures parallel to the rotation vector, e = h(s) theta, s = phi^2.
/// @tparam H  callable s -> Jet (h, dh/ds, d2h/ds2).
template <class H>
struct VectorialMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    return H{}(T(m.theta.squaredNorm())).f * m.theta;
  }

  template <class T>
  static Mat3<T> rate(const RelativeMotion<T>& m) {
    const Jet<T> h = H{}(T(m.theta.squaredNorm()));
    Mat3<T> e_theta = (T(2) * h.d1) * m.theta * m.theta.transpose();
    e_theta.diagonal().array() += h.f;
    return e_theta * so3::gamma_inverse(m.theta);
  }

  template <class T>
  static Mat3<T> transport_rate(const RelativeMotion<T>& m, const Vec3<T>& mu) {
    const Jet<T> h = H{}(T(m.theta.squaredNorm()));
    const T along = m.theta.dot(mu);
    const Vec3<T> g = h.f * mu + (T(2) * h.d1 * along) * m.theta;
    const Vec3<T> mixed = T(2) * h.d1 * mu + T(2) * h.d2 * along * m.theta;
    Mat3<T> hessian = mixed * m.theta.transpose() + m.theta * mixed.transpose();
    hessian.diagonal().array() += T(2) * h.d1 * along;
    return spin_derivative(m.theta, g, hessian);
  }
};

namespace detail {

struct RotationVectorFactor {  // phi n
  template <class T>
  Jet<T> operator()(const T&) const {
    return {T(1), T(0), T(0)};
  }
};
struct LinearFactor {  // sin(phi) n = ax(R)
  template <class T>
  Jet<T> operator()(const T& s) const {
    const Stumpff<T> c = stumpff(s);
    return {c[1], c.d1(1), c.d2(1)};
  }
};
struct QuaternionFactor {  // 2 sin(phi/2) n
  template <class T>
  Jet<T> operator()(const T& s) const {
    const Stumpff<T> c = stumpff(T(s / T(4)));
    return {c[1], c.d1(1) / T(4), c.d2(1) / T(16)};
  }
};
template <int M>
struct TangentFactor {  // M tan(phi/M) n
  template <class T>
  Jet<T> operator()(const T& s) const {
    const T m2(M * M);
    const Jet<T> h = tangent_quotient(T(s / m2));
    return {h.f, h.d1 / m2, h.d2 / (m2 * m2)};
  }
};

}  // namespace detail

using RotationVectorMeasure = VectorialMeasure<detail::RotationVectorFactor>;
using LinearMeasure = VectorialMeasure<detail::LinearFactor>;
using QuaternionMeasure = VectorialMeasure<detail::QuaternionFactor>;
using CayleyMeasure = VectorialMeasure<detail::TangentFactor<2>>;
using ConformalMeasure = VectorialMeasure<detail::TangentFactor<4>>;

/// Euler angles R = R_I(e_I) R_J(e_J) R_K(e_K) about three distinct axes (0, 1, 2), listed by axis.
/// Regular for |e_J| < pi/2; at the gimbal lock the rate is infinite.
template <int I, int J, int K>
struct EulerMeasure {
  static constexpr int kParity = (J - I + 3) % 3 == 1 ? 1 : -1;

  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    using std::atan2, std::sqrt;
    const T sign(kParity);
    const Mat3<T>& R = m.R;
    const T cosine = sqrt(R(I, I) * R(I, I) + R(I, J) * R(I, J));
    Vec3<T> e;
    e[I] = atan2(T(-sign * R(J, K)), T(R(K, K)));
    e[J] = atan2(T(sign * R(I, K)), cosine);
    e[K] = atan2(T(-sign * R(I, J)), T(R(I, I)));
    return e;
  }

  template <class T>
  static Mat3<T> rate(const RelativeMotion<T>& m) {
    return axes(strain(m)).inverse();
  }

  template <class T>
  static Mat3<T> transport_rate(const RelativeMotion<T>& m, const Vec3<T>& mu) {
    const Mat3<T> S = axes(strain(m));
    const Mat3<T> S_inverse = S.inverse();
    const Vec3<T> y = S_inverse.transpose() * mu;
    Mat3<T> d = Mat3<T>::Zero();  // d(k, l) = y . d(axis k)/d(e_l)
    const Vec3<T> s_i = S.col(I), s_j = S.col(J), s_k = S.col(K);
    d(J, I) = y.dot(s_i.cross(s_j));
    d(K, I) = y.dot(s_i.cross(s_k));
    d(K, J) = y.dot(s_j.cross(s_k));
    return -S_inverse.transpose() * d * S_inverse;
  }

 private:
  /// The current axes of the three turns in P_a, column = axis: psi = S de.
  template <class T>
  static Mat3<T> axes(const Vec3<T>& e) {
    const Vec3<T> s_i = Vec3<T>::Unit(I);
    const Mat3<T> R_i = so3::exp<T>(e[I] * s_i);
    const Mat3<T> R_j = so3::exp<T>(e[J] * Vec3<T>::Unit(J));
    Mat3<T> S;
    S.col(I) = s_i;
    S.col(J) = R_i.col(J);
    S.col(K) = R_i * R_j.col(K);
    return S;
  }
};

}  // namespace halfway
