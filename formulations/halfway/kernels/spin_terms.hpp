// The terms that the spin A of a frame adds: A = 0 in frame a, 1 in frame b.
#pragma once

#include "halfway/kernels/core/loads.hpp"
#include "halfway/kernels/spins.hpp"

#include <type_traits>

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

/// A^T x, x a vector or a matrix; and -A^T x.
template <class X>
HALFWAY_INLINE X transposed_spun(const X& x, const FullSpin&) {
  return x;
}
template <class X, class Spin>
HALFWAY_INLINE X transposed_spun(const X& x, const Spin& A) {
  return A.transposed_times(x);
}
template <class T>
HALFWAY_INLINE V3<T> minus_spun(const V3<T>&, const NoSpin&) {
  return zero3<T>();
}
template <class T, class Spin>
HALFWAY_INLINE V3<T> minus_spun(const V3<T>& x, const Spin& A) {
  return -transposed_spun(x, A);
}

/// M - d(A^T x)/d(spin), constant x, as the frame sees it.
template <class T, class Spin>
HALFWAY_INLINE M3<T> minus_rate(const M3<T>& M, const V3<T>& x, const Spin& A) {
  if constexpr (std::is_same_v<Spin, FullSpin>)
    return M;
  else
    return A.plus_rate(M, -x);
}

}  // namespace halfway::kernel
