// Rotations: exponential and logarithm, their Jacobian Gamma, half rotations, Cayley, quaternions.
//
// Accuracy contract over every decade of phi from 1e-16 to pi - 1e-12, for float, double and long double;
// each line is a row of verify/studies/rotations/so3_table.cpp:
//   exp, matrix, half, cayley          4 eps, each entry, absolute
//   log, quaternion, gamma,
//   gamma_inverse, cayley_inverse      4 eps of the largest entry of the result
// The reference is the same input at 50 digits. eps is that of the scalar. At 50 digits themselves every
// function keeps its power series or defining equation to 500 eps; exp and log carry the derivative of dual
// numbers to 16 eps of double (so3_formulas.cpp). Nothing is promised of other scalars.
#pragma once

#include "halfway/rotations/isotropic.hpp"

#include <cmath>

namespace halfway::so3 {

/// Unit quaternion (w, v) = (cos(phi/2), sin(phi/2) n).
template <class T>
struct Quaternion {
  T w;
  Vec3<T> v;
};

/// exp([theta]) as an isotropic function; with a factor xi it is exp(xi [theta]).
template <class T>
Isotropic<T> exp_isotropic(const T& s, const T& xi) {
  const T x2 = xi * xi;
  const T x4 = x2 * x2;
  const Stumpff<T> c = stumpff(T(x2 * s));
  return {{xi * c[1], xi * x2 * c.d1(1), xi * x4 * c.d2(1)}, {x2 * c[2], x4 * c.d1(2), x2 * x4 * c.d2(2)}};
}

/// Gamma(theta)^-1 as an isotropic function of theta [27], with its derivatives.
template <class T>
Isotropic<T> gamma_inverse_isotropic(const T& s) {
  return {{T(-1) / T(2), T(0), T(0)}, kappa(s)};
}

/// Rotation matrix of a rotation vector [11].
/// From cos(phi/2) and sin(phi/2)/phi, and each diagonal entry by the form that cancels less: near pi
/// the plain form 1 + c1 [theta] + c2 [theta]^2 is wrong by up to 7 eps, this one by 3.4.
/// @param theta  rotation vector, rad, any length.
template <class T>
Mat3<T> exp(const Vec3<T>& theta) {
  const Stumpff<T> half = stumpff(T(theta.squaredNorm() / T(4)));
  const T c0 = T(2) * half[0] * half[0] - T(1);
  const T c1 = half[0] * half[1];
  const T c2 = half[1] * half[1] / T(2);
  const Vec3<T> square = theta.cwiseProduct(theta);
  Mat3<T> R = c1 * skew(theta) + c2 * (theta * theta.transpose());
  for (int i = 0; i < 3; ++i) {
    const T others = square[(i + 1) % 3] + square[(i + 2) % 3];
    R(i, i) = square[i] < others ? T(c0 + c2 * square[i]) : T(T(1) - c2 * others);
  }
  return R;
}

/// Gamma(theta), spin = Gamma d(theta) [27]: the left Jacobian of the rotation group.
/// @param theta  rotation vector, rad, any length.
template <class T>
Mat3<T> gamma(const Vec3<T>& theta) {
  const Stumpff<T> c = stumpff(T(theta.squaredNorm()));
  const Mat3<T> x = skew(theta);
  return Mat3<T>::Identity() + c[2] * x + c[3] * x * x;
}

/// Gamma(theta)^-1, d(theta) = Gamma^-1 spin. @param theta  rad, |theta| < 2 pi (singular there).
template <class T>
Mat3<T> gamma_inverse(const Vec3<T>& theta) {
  const Mat3<T> x = skew(theta);
  return Mat3<T>::Identity() - x / T(2) + kappa(T(theta.squaredNorm())).f * x * x;
}

/// Quaternion of a rotation matrix, w >= 0. The largest of the four squared components is taken
/// as pivot, so nothing cancels; a slightly drifted R is projected by the final normalisation.
template <class T>
Quaternion<T> quaternion(const Mat3<T>& R) {
  using std::sqrt;
  const T trace = R.trace();
  Quaternion<T> q;
  int i = 0;
  if (R(1, 1) > R(0, 0)) i = 1;
  if (R(2, 2) > R(i, i)) i = 2;
  if (trace > R(i, i)) {
    q = {T(1) + trace, Vec3<T>(T(2) * axial(R))};
  } else {
    const int j = (i + 1) % 3;
    const int k = (i + 2) % 3;
    q.w = R(k, j) - R(j, k);
    q.v[i] = T(1) + R(i, i) - R(j, j) - R(k, k);
    q.v[j] = R(j, i) + R(i, j);
    q.v[k] = R(k, i) + R(i, k);
  }
  T norm = sqrt(q.w * q.w + q.v.squaredNorm());
  if (q.w < T(0)) norm = -norm;
  return {q.w / norm, Vec3<T>(q.v / norm)};
}

/// Rotation matrix of a unit quaternion.
template <class T>
Mat3<T> matrix(const Quaternion<T>& q) {
  const Mat3<T> x = skew(q.v);
  return Mat3<T>::Identity() + T(2) * (q.w * x + x * x);
}

namespace detail {

/// atan(r)/r of r^2 = x in [0, 1]: a series near 0, where a dual number has no square root.
template <class T>
T atan_quotient(const T& x) {
  using std::atan, std::sqrt;
  constexpr double kSwitch = 0.04;  // r = 0.2, phi = 0.79 rad
  if (x > T(kSwitch)) {
    const T r = sqrt(x);
    return atan(r) / r;
  }
  constexpr int kTerms = RealDigits<T>::value * 10 / 46 + 2;  // 0.04 = 2^-4.64 a term
  T sum(0);
  for (int k = kTerms; k >= 0; --k) sum = T(1) / T(2 * k + 1) - x * sum;
  return sum;
}

}  // namespace detail

/// Rotation vector of a unit quaternion with w >= 0: theta = 4 atan(|u|)/|u| u, u = v/(1 + w).
template <class T>
Vec3<T> log(const Quaternion<T>& q) {
  const Vec3<T> u = q.v / (T(1) + q.w);
  return T(4) * detail::atan_quotient(T(u.squaredNorm())) * u;
}

/// Rotation vector of a rotation matrix [5], |theta| <= pi.
template <class T>
Vec3<T> log(const Mat3<T>& R) {
  return log(quaternion(R));
}

/// The half rotation of q, w >= 0: no trigonometric function, singular at phi = 2 pi only.
template <class T>
Quaternion<T> half(const Quaternion<T>& q) {
  using std::sqrt;
  const T norm = sqrt(T(2) * (T(1) + q.w));
  return {(T(1) + q.w) / norm, Vec3<T>(q.v / norm)};
}

/// The half rotation [13]: half(R) half(R) = R, with an angle of at most pi/2.
template <class T>
Mat3<T> half(const Mat3<T>& R) {
  return matrix(half(quaternion(R)));
}

/// Cayley's transform [70]: (1 - [zeta])^-1 (1 + [zeta]), zeta = tan(phi/2) n.
template <class T>
Mat3<T> cayley(const Vec3<T>& zeta) {
  const Mat3<T> x = skew(zeta);
  return Mat3<T>::Identity() + (T(2) / (T(1) + zeta.squaredNorm())) * (x + x * x);
}

/// zeta = tan(phi/2) n of a rotation matrix with phi < pi (infinite at pi).
template <class T>
Vec3<T> cayley_inverse(const Mat3<T>& R) {
  const Quaternion<T> q = quaternion(R);
  return q.v / q.w;
}

}  // namespace halfway::so3
