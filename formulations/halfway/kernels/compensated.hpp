// The vector part of the relative quaternion to full relative precision, however small the rotation.
//
// Between two generic frames the plain difference of products has an absolute error of the order of
// eps, so at phi = 1e-12 four digits are left. Error-free products and sums keep them all (Dekker 1971,
// Ogita, Rump and Oishi 2005). For double and float without fused contraction of products.
#pragma once

#include "halfway/kernels/motion.hpp"

#include <type_traits>

namespace halfway::kernel {

namespace detail {

/// A value and what its rounding lost.
template <class T>
struct Exact {
  T value, lost;
};

/// Keeps the compiler from fusing x into a later operation.
template <class T>
HALFWAY_INLINE void keep(T& x) {
#if defined(__x86_64__)
  asm("" : "+x"(x));
#endif
}

template <class T>
HALFWAY_INLINE Exact<T> product(const T& a, const T& b) {
  T p = a * b;
  keep(p);
#if defined(__FMA__)
  return {p, std::fma(a, b, -p)};
#else
  const T splitter = T((1LL << ((std::numeric_limits<T>::digits + 1) / 2)) + 1);
  const auto split = [&](const T& x) {
    T c = splitter * x;
    keep(c);
    T high = c - (c - x);
    keep(high);
    return Exact<T>{high, x - high};
  };
  const Exact<T> x = split(a), y = split(b);
  T hh = x.value * y.value, hl = x.value * y.lost, lh = x.lost * y.value, ll = x.lost * y.lost;
  keep(hh), keep(hl), keep(lh), keep(ll);
  return {p, ((hh - p) + hl + lh) + ll};
#endif
}

template <class T>
HALFWAY_INLINE Exact<T> sum(const T& a, const T& b) {
  T s = a + b;
  keep(s);
  const T bb = s - a;
  return {s, (a - (s - bb)) + (b - bb)};
}

/// a b - c d as an unevaluated sum of two numbers.
template <class T>
HALFWAY_INLINE Exact<T> difference(const T& a, const T& b, const T& c, const T& d) {
  const Exact<T> p = product(a, b), q = product(c, d), s = sum(p.value, T(-q.value));
  return {s.value, s.lost + (p.lost - q.lost)};
}
template <class T>
HALFWAY_INLINE T rounded(const Exact<T>& u, const Exact<T>& c) {
  const Exact<T> s = sum(u.value, c.value);
  return s.value + (s.lost + (u.lost + c.lost));
}

}  // namespace detail

/// Relative error of the order of eps at any phi. Costs about 130 flops more without, 40 with a fused
/// multiply-add. Scalars of more digits are taken plainly.
struct Compensated {
  template <class T>
  static HALFWAY_INLINE void vectors(const Quat<T>& a, const Quat<T>& b, V3<T>& v, V3<T>& g) {
    if constexpr (!std::is_floating_point_v<T>) {
      Uncompensated::vectors(a, b, v, g);
    } else {
      const auto entry = [&](const T& a1, const T& b1, const T& a2, const T& b2, const T& a3, const T& b3,
                             T& v1, T& g1) HALFWAY_INLINE_LAMBDA {
        const auto u = detail::difference(a.w, b1, b.w, a1), c = detail::difference(a2, b3, a3, b2);
        v1 = detail::rounded(u, {-c.value, -c.lost});
        g1 = detail::rounded(u, c);
      };
      entry(a.v.x, b.v.x, a.v.y, b.v.y, a.v.z, b.v.z, v.x, g.x);
      entry(a.v.y, b.v.y, a.v.z, b.v.z, a.v.x, b.v.x, v.y, g.y);
      entry(a.v.z, b.v.z, a.v.x, b.v.x, a.v.y, b.v.y, v.z, g.z);
    }
  }
};

}  // namespace halfway::kernel
