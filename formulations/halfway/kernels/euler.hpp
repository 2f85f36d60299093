// Euler angles on the relative quaternion: values, rate and the rate's derivative in the axes of a.
#pragma once

#include "halfway/kernels/measures.hpp"

namespace halfway::kernel {

namespace detail {
template <int i, class V>
HALFWAY_INLINE auto& at(V& v) {
  if constexpr (i == 0)
    return v.x;
  else if constexpr (i == 1)
    return v.y;
  else
    return v.z;
}
}  // namespace detail

/// R = R_I(e_I) R_J(e_J) R_K(e_K) about the three axes in that order; e is listed by axis.
template <class Measure>
struct EulerKernel;

template <int I, int J, int K>
struct EulerKernel<EulerMeasure<I, J, K>> {
  static constexpr double kSign = EulerMeasure<I, J, K>::kParity;

  template <class T>
  struct Values {
    V3<T> e;
    M3<T> E;              ///< de = E dspin, rows by axis
    V3<T> s_i, s_j, s_k;  ///< the axes of the three turns
  };

  /// Infinite at the gimbal lock |e_J| = pi/2.
  template <bool with_rate, class T>
  static HALFWAY_INLINE Values<T> values(const Relative<T>& r) {
    using detail::at, std::sqrt;
    const T sign(kSign);
    const M3<T> R = matrix(Quat<T>{r.w, r.v});
    const T rii = at<I>(at<I>(R)), rij = at<J>(at<I>(R)), rik = at<K>(at<I>(R));
    const T rjk = at<K>(at<J>(R)), rkk = at<K>(at<K>(R));
    const T cj = sqrt(rii * rii + rij * rij), sj = sign * rik;
    Values<T> out;
    at<I>(out.e) = angle_of<T>(-sign * rjk, rkk);
    at<J>(out.e) = angle_of<T>(sj, cj);
    at<K>(out.e) = angle_of<T>(-sign * rij, rii);
    if constexpr (with_rate) {
      const T icj = T(1) / cj, zero(0), one(1);
      const T ci = rkk * icj, si = -sign * rjk * icj;
      V3<T>&row_i = at<I>(out.E), &row_j = at<J>(out.E), &row_k = at<K>(out.E);
      at<I>(row_j) = zero, at<J>(row_j) = ci, at<K>(row_j) = sign * si;
      at<I>(row_k) = zero, at<J>(row_k) = -sign * si * icj, at<K>(row_k) = ci * icj;
      at<I>(row_i) = one, at<J>(row_i) = sj * si * icj, at<K>(row_i) = -sign * sj * ci * icj;
      at<I>(out.s_i) = one, at<J>(out.s_i) = zero, at<K>(out.s_i) = zero;
      at<I>(out.s_j) = zero, at<J>(out.s_j) = ci, at<K>(out.s_j) = sign * si;
      at<I>(out.s_k) = sign * sj, at<J>(out.s_k) = -sign * cj * si, at<K>(out.s_k) = cj * ci;
    }
    return out;
  }

  /// d(E^T mu)/d(spin) for constant mu; y = E^T mu.
  template <class T>
  static HALFWAY_INLINE M3<T> transport_rate(const Values<T>& v, const V3<T>& y) {
    const V3<T>&row_i = detail::at<I>(v.E), &row_j = detail::at<J>(v.E), &row_k = detail::at<K>(v.E);
    const T ji = dot(y, cross(v.s_i, v.s_j)), ki = dot(y, cross(v.s_i, v.s_k)),
            kj = dot(y, cross(v.s_j, v.s_k));
    return -(outer(row_j, ji * row_i) + outer(row_k, ki * row_i + kj * row_j));
  }
};

template <class M>
inline constexpr bool kEuler = requires {
  EulerKernel<M>::kSign;
};

}  // namespace halfway::kernel
