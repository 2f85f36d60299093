// What a kernel returns, and what follows from it: loads about the nodes and the whole tangent.
#pragma once

#include "halfway/kernels/core/small.hpp"

namespace halfway::kernel {

/// Moment on node b (a has the opposite), N m, and its derivatives by the spins; global axes.
template <class T>
struct MomentLoads {
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
/// the rest follows from objectivity and balance, and is cheapest last; or it has an at_nodes() that fills
/// all.
template <class T>
struct PointLoads {
  Load<T> f, a, b;
};

/// To what takes loads' parts.
template <bool with_tangent, class T, class Out>
HALFWAY_INLINE void assign(const MomentLoads<T>& l, Out& out) {
  out.m = l.m;
  if constexpr (with_tangent) out.wa = l.wa, out.wb = l.wb;
}
template <bool with_tangent, class T, class Out>
HALFWAY_INLINE void assign(const Load<T>& l, Out& out) {
  out.value = l.value;
  if constexpr (with_tangent) out.x = l.x, out.wa = l.wa, out.wb = l.wb;
}
template <bool with_tangent, class T, class Out>
HALFWAY_INLINE void assign(const PointLoads<T>& l, Out& out) {
  assign<with_tangent>(l.f, out.f), assign<with_tangent>(l.a, out.a), assign<with_tangent>(l.b, out.b);
}

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

/// What follows: the columns of w_a, and a's moment from balance, m_a = -(m_b + d x f); where there is a
/// potential, mixed derivatives are each other's transposes.
/// @param d  from the point about which a's moment is taken to that of b's, m
template <bool balanced, bool conservative, bool with_tangent, class T>
HALFWAY_INLINE void complete(const V3<T>& d, PointLoads<T>& p) {
  static_assert(balanced || !conservative);
  if constexpr (with_tangent) complete_column(d, p.f), complete_column(d, p.b);
  if constexpr (balanced) {
    p.a.value = -(p.b.value + cross(d, p.f.value));
    if constexpr (with_tangent && conservative) {
      p.a.x = transposed(p.f.wa);
      p.a.wb = transposed(p.b.wa);
    } else if constexpr (with_tangent) {
      p.a.x = plus_skew(-(p.b.x + skew_times(d, p.f.x)), p.f.value);
      p.a.wb = -(p.b.wb + skew_times(d, p.f.wb));
    }
  }
  if constexpr (with_tangent) complete_column(d, p.a);
}

/// Three rows of the 12 x 12 tangent from `row` on, by columns (x_a, w_a, x_b, w_b).
/// @param out  anything whose matrix(i, m, step) puts a block's rows from entry i on, `step` apart
template <class Out, class T>
HALFWAY_INLINE void put_rows(const Out& out, int row, const Load<T>& l) {
  const int i = 12 * row;
  out.matrix(i, -l.x, 12), out.matrix(i + 3, l.wa, 12), out.matrix(i + 6, l.x, 12),
      out.matrix(i + 9, l.wb, 12);
}
/// The tangent of (f_a, m_a, f_b, m_b).
template <class Out, class T>
HALFWAY_INLINE void put_tangent(const Out& out, const PointLoads<T>& l) {
  put_rows(out, 0, Load<T>{{}, -l.f.x, -l.f.wa, -l.f.wb});
  put_rows(out, 3, l.a), put_rows(out, 6, l.f), put_rows(out, 9, l.b);
}

/// Numbers one after the other in memory.
template <class T>
struct Entries {
  T* first;

  HALFWAY_INLINE void vector(int i, const V3<T>& v) const {
    first[i] = v.x, first[i + 1] = v.y, first[i + 2] = v.z;
  }
  HALFWAY_INLINE void matrix(int i, const M3<T>& m, int step) const {
    vector(i, m.x), vector(i + step, m.y), vector(i + 2 * step, m.z);
  }
};

/// Moment on b, then its 3 x 6 tangent by rows, columns (w_a, w_b).
template <bool with_tangent, class T>
HALFWAY_INLINE void expand(const MomentLoads<T>& l, T* out) {
  const Entries<T> entries{out};
  entries.vector(0, l.m);
  if constexpr (with_tangent) entries.matrix(3, l.wa, 6), entries.matrix(6, l.wb, 6);
}

/// Loads (f_a, m_a, f_b, m_b), then their 12 x 12 tangent by rows.
template <bool with_tangent, class T>
HALFWAY_INLINE void expand(const PointLoads<T>& l, T* out) {
  const Entries<T> entries{out};
  entries.vector(0, -l.f.value), entries.vector(3, l.a.value);
  entries.vector(6, l.f.value), entries.vector(9, l.b.value);
  if constexpr (with_tangent) put_tangent(Entries<T>{out + 12}, l);
}

}  // namespace halfway::kernel
