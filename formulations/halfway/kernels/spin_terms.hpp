// The terms that the spin A of a frame adds: A = 0 in frame a, 1 in frame b.
#pragma once

#include "halfway/kernels/loads.hpp"
#include "halfway/kernels/spins.hpp"

namespace halfway::kernel {

/// M A.
template <class T>
HALFWAY_INLINE M3<T> spun(const M3<T>& M, const FullSpin&) {
  return M;
}
template <class T, class Spin>
HALFWAY_INLINE M3<T> spun(const M3<T>& M, const Spin& A) {
  return A.after(M);
}

/// M - [x] A: the frame turns x with it.
template <class T>
HALFWAY_INLINE M3<T> minus_turn(const M3<T>& M, const V3<T>&, const NoSpin&) {
  return M;
}
template <class T>
HALFWAY_INLINE M3<T> minus_turn(const M3<T>& M, const V3<T>& x, const FullSpin&) {
  return minus_skew(M, x);
}
template <class T>
HALFWAY_INLINE M3<T> minus_turn(const M3<T>& M, const V3<T>& x, const HalfSpin<T>& A) {
  // -[x](1 - [z])/2, and [x][z] = z x^T - (x . z).
  const V3<T> half = T(0.5) * x;
  return minus_skew(plus_diagonal(M + outer(A.z, half), -dot(A.z, half)), half);
}
template <class T>
HALFWAY_INLINE M3<T> minus_turn(const M3<T>& M, const V3<T>& x, const WeightedSpin<T>& A) {
  const M3<T> turned_by_q = plus_diagonal(outer(-A.q * A.g, x), A.q * dot(A.g, x));
  return minus_skew(M + turned_by_q - outer(cross(x, A.r * A.g), A.g), A.p * x);
}

/// The arm of the force in a frame that turns with the nodes: moment -A^T (d x f) on b [24, 30], with its
/// derivatives by d and by the relative spin, as seen in the frame; f_w: d(f)/d(spin), ditto.
template <bool with_tangent, bool with_f_w, class T>
HALFWAY_INLINE Load<T> arm(const V3<T>& d, const V3<T>& f, const M3<T>& f_d, const M3<T>& f_w,
                           const FullSpin&) {
  Load<T> l;
  l.value = -cross(d, f);
  if constexpr (with_tangent) {
    l.x = plus_skew(-skew_times(d, f_d), f);
    if constexpr (with_f_w) l.wb = -skew_times(d, f_w);
  }
  return l;
}
template <bool with_tangent, bool with_f_w, class T, class Spin>
HALFWAY_INLINE Load<T> arm(const V3<T>& d, const V3<T>& f, const M3<T>& f_d, const M3<T>& f_w,
                           const Spin& A) {
  Load<T> l;
  const V3<T> moment = cross(d, f);
  l.value = -A.transposed_times(moment);
  if constexpr (with_tangent) {
    l.x = A.transposed_times(plus_skew(-skew_times(d, f_d), f));
    if constexpr (with_f_w)
      l.wb = -A.plus_rate(A.transposed_times(skew_times(d, f_w)), moment);
    else
      l.wb = -A.plus_rate(zero33<T>(), moment);
  }
  return l;
}

}  // namespace halfway::kernel
