// Equilibrium of an angular joint under a moment of fixed direction, by Newton on its kernel.
#pragma once

#include "halfway/kernels/joint.hpp"

namespace halfway::kernel {

/// K^-1 r by cofactors; not finite where K is singular.
template <class T>
HALFWAY_INLINE V3<T> solved(const M3<T>& K, const V3<T>& r) {
  const V3<T> yz = cross(K.y, K.z), zx = cross(K.z, K.x), xy = cross(K.x, K.y);
  return (T(1) / dot(K.x, yz)) * (r.x * yz + r.y * zx + r.z * xy);
}

/// q turned by a small rotation vector: a retraction of second order, which is all that Newton needs.
template <class T>
HALFWAY_INLINE Quat<T> displaced(const Quat<T>& q, const V3<T>& step) {
  using std::sqrt;
  const Quat<T> p = Quat<T>{T(1), T(0.5) * step} * q;
  const T s = T(1) / sqrt(p.w * p.w + dot(p.v, p.v));
  return {s * p.w, s * p.v};
}

template <class T>
struct AngularEquilibrium {
  Quat<T> b;
  int iterations = 0;  ///< 0: none of the iterations allowed converged
};

/// One load step from `b`: until a step is below 1e-8 rad, after which the next would be rounding.
/// @param moment  on node b, global axes, N m; `b` unit quaternion of node b to start from
template <class T, class K, class L, class E>
AngularEquilibrium<T> solve(const Joint<Kind::angular, K, L, E>& joint, const Quat<T>& a, Quat<T> b,
                            const V3<T>& moment, int iterations = 12) {
  const T small(1e-16);  // of a step squared
  for (int i = 1; i <= iterations; ++i) {
    const AngularLoads<T> l = loads<true>(joint, a, b);
    const V3<T> step = solved(l.wb, moment - l.m);
    const T size = dot(step, step);
    if (!(size < T(10))) break;  // singular, or far beyond any sensible step
    b = displaced(b, step);
    if (size < small) return {b, i};
  }
  return {b, 0};
}

}  // namespace halfway::kernel
