// Constitutive laws of the kernels: three strains, or six as (translation, rotation).
//
// A law offers stress(...) and stiffness(...); C is the type of its numbers: T, or a plain number that
// all joints of a pack share. Stiffness is symmetric and stored once.
#pragma once

#include "halfway/kernels/core/small.hpp"

namespace halfway::kernel {

/// Force (or displacement) and moment (or rotation) of a linear/angular law.
template <class T>
struct Pair {
  V3<T> f, m;
};

/// d(stress)/d(strain) of six strains; fm: force by rotation, its transpose: moment by translation.
template <class T>
struct Stiffness6 {
  S3<T> ff;
  M3<T> fm;
  S3<T> mm;
};

/// May six strains of the law be coupled? A kernel may leave out what is zero then.
template <class L>
inline constexpr bool kCoupled = !requires {
  requires !L::kCoupled;
};

template <class C>
struct Linear3 {
  static constexpr bool kLinear = true;
  S3<C> K;

  template <class T>
  HALFWAY_INLINE V3<T> stress(const V3<T>& e) const {
    return stiffness(e) * e;
  }
  template <class T>
  HALFWAY_INLINE S3<T> stiffness(const V3<T>&) const {
    return {T(K.xx), T(K.xy), T(K.xz), T(K.yy), T(K.yz), T(K.zz)};
  }
};

template <class C>
struct Linear6 {
  static constexpr bool kLinear = true;
  Stiffness6<C> K;

  template <class T>
  HALFWAY_INLINE Pair<T> stress(const Pair<T>& e) const {
    const Stiffness6<T> k = stiffness(e);
    return {k.ff * e.f + k.fm * e.m, e.f * k.fm + k.mm * e.m};
  }
  template <class T>
  HALFWAY_INLINE Stiffness6<T> stiffness(const Pair<T>& e) const {
    const M3<C>& c = K.fm;
    return {Linear3<C>{K.ff}.stiffness(e.f),
            {{T(c.x.x), T(c.x.y), T(c.x.z)}, {T(c.y.x), T(c.y.y), T(c.y.z)}, {T(c.z.x), T(c.z.y), T(c.z.z)}},
            Linear3<C>{K.mm}.stiffness(e.m)};
  }
};

/// The same where translation and rotation are not coupled.
template <class C>
struct BlockDiagonal6 {
  static constexpr bool kLinear = true;
  static constexpr bool kCoupled = false;
  Linear3<C> f, m;

  template <class T>
  HALFWAY_INLINE Pair<T> stress(const Pair<T>& e) const {
    return {f.stress(e.f), m.stress(e.m)};
  }
  template <class T>
  HALFWAY_INLINE Stiffness6<T> stiffness(const Pair<T>& e) const {
    return {f.stiffness(e.f), zero33<T>(), m.stiffness(e.m)};
  }
};

/// stress = k1 e + k3 e^3 + k5 e^5 per axis.
template <class C>
struct Polynomial3 {
  static constexpr bool kLinear = false;
  V3<C> k1, k3, k5;

  template <class T>
  HALFWAY_INLINE V3<T> stress(const V3<T>& e) const {
    const auto one = [](const T& x, const C& a, const C& b, const C& c) {
      const T s = x * x;
      return x * (T(a) + s * (T(b) + s * T(c)));
    };
    return {one(e.x, k1.x, k3.x, k5.x), one(e.y, k1.y, k3.y, k5.y), one(e.z, k1.z, k3.z, k5.z)};
  }
  template <class T>
  HALFWAY_INLINE S3<T> stiffness(const V3<T>& e) const {
    const auto one = [](const T& x, const C& a, const C& b, const C& c) {
      const T s = x * x;
      return T(a) + s * (T(3) * T(b) + s * (T(5) * T(c)));
    };
    const T zero(0);
    return {one(e.x, k1.x, k3.x, k5.x), zero, zero,
            one(e.y, k1.y, k3.y, k5.y), zero, one(e.z, k1.z, k3.z, k5.z)};
  }
};

template <class C>
struct Polynomial6 {
  static constexpr bool kLinear = false;
  static constexpr bool kCoupled = false;
  Polynomial3<C> f, m;

  template <class T>
  HALFWAY_INLINE Pair<T> stress(const Pair<T>& e) const {
    return {f.stress(e.f), m.stress(e.m)};
  }
  template <class T>
  HALFWAY_INLINE Stiffness6<T> stiffness(const Pair<T>& e) const {
    return {f.stiffness(e.f), zero33<T>(), m.stiffness(e.m)};
  }
};

}  // namespace halfway::kernel
