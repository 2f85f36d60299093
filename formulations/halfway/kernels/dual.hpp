// A number with its derivative along one direction, for a kernel's product J v without its tangent.
//
// The law and the polynomials of the angle are not carried through the dual arithmetic: they know
// their own derivatives (LawAlong, Along).
#pragma once

#include "halfway/kernels/core/functions.hpp"
#include "halfway/kernels/laws.hpp"

namespace halfway::kernel {

/// v + d e, e^2 = 0.
template <class T>
struct Dual {
  T v, d;

  Dual() = default;
  HALFWAY_INLINE explicit Dual(double x) : v(x), d(0.0) {}
  HALFWAY_INLINE explicit Dual(const T& x) : v(x), d(0.0) {}
  HALFWAY_INLINE Dual(const T& value, const T& derivative) : v(value), d(derivative) {}

  friend HALFWAY_INLINE Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.d + b.d}; }
  friend HALFWAY_INLINE Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.d - b.d}; }
  friend HALFWAY_INLINE Dual operator-(const Dual& a) { return {-a.v, -a.d}; }
  friend HALFWAY_INLINE Dual operator*(const Dual& a, const Dual& b) {
    return {a.v * b.v, a.d * b.v + a.v * b.d};
  }
  friend HALFWAY_INLINE Dual operator/(const Dual& a, const Dual& b) {
    const T inverse = T(1.0) / b.v, quotient = a.v * inverse;
    return {quotient, (a.d - quotient * b.d) * inverse};
  }
  friend HALFWAY_INLINE Dual sqrt(const Dual& a) {
    const T root = sqrt(a.v);
    return {root, T(0.5) * a.d / root};
  }
  friend HALFWAY_INLINE Dual sign_of(const Dual& a) { return Dual(sign_of(a.v)); }
  friend HALFWAY_INLINE Dual where_negative(const Dual& x, const Dual& negative, const Dual& other) {
    return {where_negative(x.v, negative.v, other.v), where_negative(x.v, negative.d, other.d)};
  }
};

template <class T>
struct Digits<Dual<T>> : Digits<T> {};

/// The angle of a dual number: the jet's own next order is the derivative.
template <class Angle>
struct Along {
  template <int order, class T>
  static HALFWAY_INLINE AngleJet<Dual<T>> jet(const HalfAngle<Dual<T>>& x) {
    const T& t_d = x.t.d;
    const AngleJet<T> j = Angle::template jet<order + 1>(HalfAngle<T>{x.t.v, x.w.v, x.iw.v});
    AngleJet<Dual<T>> out;
    out.h = {j.h, (j.d + j.d) * t_d};  // d = h'/2, d1 = -h''/2, d2 = h'''/2 by t
    if constexpr (order >= 1) out.d = {j.d, -(j.d1 * t_d)};
    if constexpr (order >= 2) out.d1 = {j.d1, -(j.d2 * t_d)};
    return out;
  }
};

template <class T>
HALFWAY_INLINE V3<T> value(const V3<Dual<T>>& x) {
  return {x.x.v, x.y.v, x.z.v};
}
template <class T>
HALFWAY_INLINE V3<T> derivative(const V3<Dual<T>>& x) {
  return {x.x.d, x.y.d, x.z.d};
}
template <class T>
HALFWAY_INLINE V3<Dual<T>> dual(const V3<T>& v, const V3<T>& d) {
  return {{v.x, d.x}, {v.y, d.y}, {v.z, d.z}};
}

/// A law along the direction: its derivative is its stiffness.
template <class L>
struct LawAlong {
  static constexpr bool kLinear = false;
  const L& law;

  template <class T>
  HALFWAY_INLINE V3<Dual<T>> stress(const V3<Dual<T>>& e) const {
    const V3<T> at = value(e);
    return dual(law.stress(at), law.stiffness(at) * derivative(e));
  }
  template <class T>
  HALFWAY_INLINE Pair<Dual<T>> stress(const Pair<Dual<T>>& e) const {
    const Pair<T> at{value(e.f), value(e.m)}, along{derivative(e.f), derivative(e.m)};
    const Pair<T> s = law.stress(at);
    const Stiffness6<T> k = law.stiffness(at);
    return {dual(s.f, k.ff * along.f + k.fm * along.m), dual(s.m, along.f * k.fm + k.mm * along.m)};
  }
};

}  // namespace halfway::kernel
