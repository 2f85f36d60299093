// Relative rotation of two joint frames from their unit quaternions, and the frames between them.
#pragma once

#include "halfway/kernels/core/functions.hpp"

namespace halfway::kernel {

/// Unit quaternion (w, v), rotating joint axes to global ones.
template <class T>
struct Quat {
  T w;
  V3<T> v;
};

template <class T>
HALFWAY_INLINE Quat<T> operator*(const Quat<T>& a, const Quat<T>& b) {
  return {a.w * b.w - dot(a.v, b.v), a.w * b.v + b.w * a.v + cross(a.v, b.v)};
}

/// Rotation matrix of a quaternion of squared norm 2/n: unit ones have n = 2.
template <class T>
HALFWAY_INLINE M3<T> matrix(const Quat<T>& q, const T& n) {
  const V3<T> s = n * q.v;
  const T xx = s.x * q.v.x, yy = s.y * q.v.y, zz = s.z * q.v.z;
  const T xy = s.x * q.v.y, xz = s.x * q.v.z, yz = s.y * q.v.z;
  const V3<T> r = q.w * s;
  const T one(1);
  return {{one - (yy + zz), xy - r.z, xz + r.y},
          {xy + r.z, one - (xx + zz), yz - r.x},
          {xz - r.y, yz + r.x, one - (xx + yy)}};
}
template <class T>
HALFWAY_INLINE M3<T> matrix(const Quat<T>& q) {
  return matrix(q, T(2));
}

/// The rotation from joint frame a to joint frame b, phi in [0, pi]: w = cos(phi/2) >= 0 and the
/// vector part sin(phi/2) n, in the joint's axes (v: the same components in frame a, b or between)
/// and in global axes (g).
template <class T>
struct Relative {
  Quat<T> a, b;  ///< b turned to the side of a
  T w;
  V3<T> v, g;
  T iw;  ///< 1 / (1 + w)
  T s2;  ///< v . v
  T t;   ///< 1 - w, without cancellation

  /// Frame half-way between [13]: the normalised sum.
  HALFWAY_INLINE M3<T> halfway() const { return matrix(Quat<T>{a.w + b.w, a.v + b.v}, iw); }
};

/// Plain differences of products: absolute error of the order of eps.
struct Uncompensated {
  template <class T>
  static HALFWAY_INLINE void vectors(const Quat<T>& a, const Quat<T>& b, V3<T>& v, V3<T>& g) {
    const V3<T> u = a.w * b.v - b.w * a.v, c = cross(a.v, b.v);
    v = u - c;
    g = u + c;
  }
};

/// @param qa, qb  unit quaternions of the joint frames; their signs do not matter.
template <class Differences = Uncompensated, class T>
HALFWAY_INLINE Relative<T> relative(const Quat<T>& qa, const Quat<T>& qb) {
  Relative<T> r;
  const T cosine = qa.w * qb.w + dot(qa.v, qb.v);
  const T side = sign_of(cosine);
  r.a = qa;
  r.b = {side * qb.w, side * qb.v};
  r.w = side * cosine;
  Differences::vectors(r.a, r.b, r.v, r.g);
  r.iw = T(1) / (T(1) + r.w);
  r.s2 = dot(r.v, r.v);
  r.t = r.s2 * r.iw;
  return r;
}

/// For a law that no rotation concerns: frame a alone is set.
template <class T>
HALFWAY_INLINE Relative<T> frame_a_alone(const Quat<T>& qa) {
  Relative<T> r{};
  r.a = qa;
  return r;
}

}  // namespace halfway::kernel
