// Equilibrium of an angular joint under a moment of fixed direction, by Newton on its kernel.
#pragma once

#include "halfway/equilibrium/newton.hpp"
#include "halfway/kernels/joint.hpp"

#include <limits>

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
HALFWAY_INLINE V3<T> sizes(const V3<T>& v) {
  using std::abs;
  return {T(abs(v.x)), T(abs(v.y)), T(abs(v.z))};
}

/// A joint under a moment: the system of Newton's method (halfway/equilibrium/newton.hpp).
template <class T, class JointT>
struct LoadedAngular {
  const JointT& joint;
  const Quat<T>& a;
  const V3<T>& moment;  ///< on node b, global axes, N m
  Quat<T> b;
  V3<T> step{};

  HALFWAY_INLINE NewtonLook<T> look() {
    using std::sqrt;
    const MomentLoads<T> l = loads<true>(joint, a, b);
    const V3<T> imbalance = moment - l.m;
    step = solved(l.wb, imbalance);
    const V3<T> s = sizes(step), off = sizes(imbalance);
    // The rounding of both moments, and of the rotation magnified by the tangent.
    const T size = length(moment), turned = turn();
    const V3<T> by_turn = {length(l.wb.x), length(l.wb.y), length(l.wb.z)};
    const V3<T> rounding = kRounding * (V3<T>{size, size, size} + sizes(l.m) + turned * by_turn);
    return {sqrt(dot(s, off)), off.x <= rounding.x && off.y <= rounding.y && off.z <= rounding.z};
  }
  HALFWAY_INLINE void move() { b = displaced(b, step); }

 private:
  static constexpr T kRounding = 8 * std::numeric_limits<T>::epsilon();

  static T length(const V3<T>& v) {
    using std::sqrt;
    return sqrt(dot(v, v));
  }
  /// 2 sin(phi/2) of b seen from a: at least 2/pi of the angle, rad.
  T turn() const { return T(2) * length((Quat<T>{a.w, T(-1) * a.v} * b).v); }
};

template <class T>
struct AngularEquilibrium {
  Quat<T> b;
  int iterations = 0;  ///< Newton's corrections; 0: those allowed did not converge
};

/// One load step from `b`, until the imbalance is rounding in each direction.
/// @param moment  on node b, global axes, N m; `b` unit quaternion of node b to start from
template <class T, class K, class L, class E>
AngularEquilibrium<T> solve(const KernelJoint<Kind::angular, K, L, E>& joint, const Quat<T>& a, Quat<T> b,
                            const V3<T>& moment, int iterations = 12) {
  LoadedAngular<T, KernelJoint<Kind::angular, K, L, E>> system{joint, a, moment, b};
  const NewtonRun<T> run = newton<T>(system, iterations);
  return {system.b, run.stop == NewtonStop::rounding ? run.corrections : 0};
}

}  // namespace halfway::kernel
