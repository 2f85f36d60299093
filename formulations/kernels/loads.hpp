// What a kernel returns, and what follows from it: loads about the nodes and the whole tangent.
#pragma once

#include "formulations/kernels/small.hpp"

namespace halfway::kernel {

/// Moment on node b (a has the opposite), N m, and its derivatives by the spins; global axes.
template <class T>
struct AngularLoads {
  V3<T> m;
  M3<T> wa, wb;
};

/// One load with its derivatives by the position of b (that by a's is the opposite) and the spins.
template <class T>
struct Load {
  V3<T> value;
  M3<T> x, wa, wb;
};

/// Force on b (a has the opposite), moments on a and b; global axes, N, N m. With derivatives these
/// are the 81 distinct numbers of the 144 of the tangent.
///
/// A kernel fills value, x and wb of f and b, and of a too where it is not balanced (kBalanced):
/// the rest follows from objectivity and balance, and is cheapest last.
template <class T>
struct PointLoads {
  Load<T> f, a, b;
};

/// From the joint points to the nodes: the joint points are at r_a, r_b from them (global axes, m).
template <bool balanced, bool with_tangent, class T>
HALFWAY_INLINE void carry(const V3<T>& r_a, const V3<T>& r_b, PointLoads<T>& p) {
  const V3<T>& f = p.f.value;
  if constexpr (with_tangent) {
    p.f.wb = p.f.wb - times_skew(p.f.x, r_b);
    // The arm turns with its node: d(r) x f = [f][r] w, and [f][r] = r f^T - (r . f).
    const M3<T> turning = plus_diagonal(outer(r_b, f), -dot(r_b, f));
    p.b.wb = p.b.wb - times_skew(p.b.x, r_b) + skew_times(r_b, p.f.wb) + turning;
    p.b.x = p.b.x + skew_times(r_b, p.f.x);
    if constexpr (!balanced) {
      p.a.wb = p.a.wb - times_skew(p.a.x, r_b) - skew_times(r_a, p.f.wb);
      p.a.x = p.a.x - skew_times(r_a, p.f.x);
    }
  }
  p.b.value = p.b.value + cross(r_b, f);
  if constexpr (!balanced) p.a.value = p.a.value - cross(r_a, f);
}

/// Column of w_a by objectivity: a rigid turn of everything about a turns the load.
template <class T>
HALFWAY_INLINE void complete_column(const V3<T>& d, Load<T>& l) {
  l.wa = minus_skew(times_skew(l.x, d) - l.wb, l.value);
}

/// What follows: the columns of w_a, and a's moment from balance, m_a = -(m_b + d x f).
/// @param d  from the point about which a's moment is taken to that of b's, m
template <bool balanced, bool with_tangent, class T>
HALFWAY_INLINE void complete(const V3<T>& d, PointLoads<T>& p) {
  if constexpr (with_tangent) complete_column(d, p.f), complete_column(d, p.b);
  if constexpr (balanced) {
    p.a.value = -(p.b.value + cross(d, p.f.value));
    if constexpr (with_tangent) {
      p.a.x = plus_skew(-(p.b.x + skew_times(d, p.f.x)), p.f.value);
      p.a.wb = -(p.b.wb + skew_times(d, p.f.wb));
    }
  }
  if constexpr (with_tangent) complete_column(d, p.a);
}

namespace detail {
template <class T>
HALFWAY_INLINE void put(T* out, const V3<T>& v) {
  out[0] = v.x, out[1] = v.y, out[2] = v.z;
}
/// Rows of a block into rows of a matrix with `columns` columns.
template <int columns, class T>
HALFWAY_INLINE void put(T* out, const M3<T>& m) {
  put(out, m.x), put(out + columns, m.y), put(out + 2 * columns, m.z);
}
template <class T>
HALFWAY_INLINE void put_rows(T* out, const Load<T>& l) {
  put<12>(out, -l.x), put<12>(out + 3, l.wa), put<12>(out + 6, l.x), put<12>(out + 9, l.wb);
}
}  // namespace detail

/// Moment on b, then its 3 x 6 tangent by rows, columns (w_a, w_b).
template <bool with_tangent, class T>
HALFWAY_INLINE void expand(const AngularLoads<T>& l, T* out) {
  detail::put(out, l.m);
  if constexpr (with_tangent) detail::put<6>(out + 3, l.wa), detail::put<6>(out + 6, l.wb);
}

/// Loads (f_a, m_a, f_b, m_b), then their 12 x 12 tangent by rows, columns (x_a, w_a, x_b, w_b).
template <bool with_tangent, class T>
HALFWAY_INLINE void expand(const PointLoads<T>& l, T* out) {
  detail::put(out, -l.f.value), detail::put(out + 3, l.a.value);
  detail::put(out + 6, l.f.value), detail::put(out + 9, l.b.value);
  if constexpr (with_tangent) {
    T* const tangent = out + 12;
    detail::put_rows(tangent, Load<T>{{}, -l.f.x, -l.f.wa, -l.f.wb});
    detail::put_rows(tangent + 36, l.a);
    detail::put_rows(tangent + 72, l.f);
    detail::put_rows(tangent + 108, l.b);
  }
}

}  // namespace halfway::kernel
