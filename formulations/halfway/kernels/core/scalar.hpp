// What a kernel asks of its scalar beyond + - * /: square roots, signs, a choice without a branch.
//
// A scalar with more digits than double (50-digit arithmetic) gets series and its own functions where
// double and float get polynomials: `kPolynomials` tells them apart. A pack of joints overloads these
// functions, and so does a dual number; they are found by argument-dependent look-up.
#pragma once

#include "halfway/kernels/core/small.hpp"

#include <cmath>
#include <limits>
#include <type_traits>

namespace halfway {
template <class T>
struct RealDigits;  // binary digits of the significand, scalar.hpp
}

namespace halfway::kernel {

/// Binary digits of T: those of float, of double, or more.
template <class T>
struct Digits {
  static constexpr int value =
      std::numeric_limits<T>::is_specialized ? std::numeric_limits<T>::digits : RealDigits<T>::value;
};
template <class T>
inline constexpr bool kPolynomials = Digits<T>::value <= 53;
template <class T>
inline constexpr bool kSingle = Digits<T>::value <= 24;

/// +1 where x >= 0, otherwise -1. Not a branch: the sides of quaternions are no processor's guess.
template <class T>
HALFWAY_INLINE T sign_of(const T& x) {
  if constexpr (std::is_floating_point_v<T>)
    return std::copysign(T(1), x);
  else
    return x < T(0) ? T(-1) : T(1);
}
/// `negative` where x < 0, otherwise `other`.
template <class T>
HALFWAY_INLINE T where_negative(const T& x, const T& negative, const T& other) {
  return x < T(0) ? negative : other;
}

/// 1/x^2-like quotients of functions that vanish with x: this keeps 0/0 from being a NaN; what it
/// multiplies vanishes there.
template <class T>
HALFWAY_INLINE T tiny() {
  return T(kSingle<T> ? 1e-37 : 1e-300);
}

namespace detail {

/// c[at] + c[at + 1] x + ... (count terms) by halves (Estrin): short chains for the processor.
/// powers[i] = x^(2^i).
template <int at, int count, class T>
HALFWAY_INLINE T estrin(const double* c, const T* powers) {
  if constexpr (count == 1) {
    return T(c[at]);
  } else if constexpr (count == 2) {
    return T(c[at]) + T(c[at + 1]) * powers[0];
  } else {
    constexpr int level = count > 16 ? 4 : count > 8 ? 3 : count > 4 ? 2 : 1;
    constexpr int half = 1 << level;
    return estrin<at, half>(c, powers) + estrin<at + half, count - half>(c, powers) * powers[level];
  }
}

}  // namespace detail

/// Polynomial of a coefficient array at x, lowest power first.
template <int count, class T>
HALFWAY_INLINE T polynomial(const double (&c)[count], const T& x) {
  T powers[5] = {x, x, x, x, x};
  if constexpr (count > 2) powers[1] = x * x;
  if constexpr (count > 4) powers[2] = powers[1] * powers[1];
  if constexpr (count > 8) powers[3] = powers[2] * powers[2];
  if constexpr (count > 16) powers[4] = powers[3] * powers[3];
  return detail::estrin<0, count>(c, powers);
}

}  // namespace halfway::kernel
