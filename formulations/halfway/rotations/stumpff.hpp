// The Stumpff functions: every coefficient of the rotation group, free of cancellation.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <array>
#include <cmath>

namespace halfway {

/// c[n] = sum_k (-s)^k / (n + 2k)!, n = 0 ... 7, for s = phi^2 >= 0:
/// c0 = cos phi, c1 = sin(phi)/phi, c2 = (1 - cos phi)/phi^2, c3 = (phi - sin phi)/phi^3, ...
///
/// Two rules make them sufficient for rotations, their Jacobians and the derivatives of those:
/// c_n = 1/n! - s c_{n+2}, and dc_n/ds = (n c_{n+2} - c_{n+1})/2, neither of which divides by s.
/// Absolute error below 2 eps for s <= 10 (phi <= pi); beyond, of the order of eps.
template <class T>
struct Stumpff {
  std::array<T, 8> c;

  T operator[](int n) const { return c[n]; }

  /// First derivative in s, n = 0 ... 5.
  T d1(int n) const { return (T(n) * c[n + 2] - c[n + 1]) / T(2); }

  /// Second derivative in s, n = 0 ... 3.
  T d2(int n) const { return (T(n) * d1(n + 2) - d1(n + 1)) / T(2); }
};

namespace detail {

inline constexpr double kSeriesLimit = 10;  // just above pi^2: no switch inside the usual range

/// Terms after which the series of c6 at s = kSeriesLimit is below 2^-(digits + 2) of its sum.
constexpr int stumpff_terms(int digits) {
  double term = 1;
  double target = 1;
  for (int i = 0; i < digits + 2; ++i) target /= 2;
  int k = 0;
  while (term > target) {
    ++k;
    term *= kSeriesLimit / ((6. + 2 * k - 1) * (6. + 2 * k));
  }
  return k;
}

/// c_n by its series, nested so that each bracket is 1 - s/(..)(..) times the next one.
template <class T>
T stumpff_series(int n, const T& s, const T& inverse_factorial) {
  T sum(1);
  for (int k = stumpff_terms(RealDigits<T>::value); k > 0; --k) {
    sum = T(1) - s * sum / T((n + 2 * k - 1) * (n + 2 * k));
  }
  return sum * inverse_factorial;
}

}  // namespace detail

/// @param s  phi^2 in rad^2, s >= 0; polynomial for s <= 10, so duals are exact at s = 0.
template <class T>
Stumpff<T> stumpff(const T& s) {
  using std::cos, std::sin, std::sqrt;
  std::array<T, 8> inverse_factorial;
  inverse_factorial[0] = T(1);
  for (int n = 1; n < 8; ++n) inverse_factorial[n] = inverse_factorial[n - 1] / T(n);

  Stumpff<T> f;
  if (s <= T(detail::kSeriesLimit)) {
    f.c[7] = detail::stumpff_series(7, s, inverse_factorial[7]);
    f.c[6] = detail::stumpff_series(6, s, inverse_factorial[6]);
    for (int n = 5; n >= 0; --n) f.c[n] = inverse_factorial[n] - s * f.c[n + 2];
  } else {
    const T phi = sqrt(s);
    f.c[0] = cos(phi);
    f.c[1] = sin(phi) / phi;
    for (int n = 2; n < 8; ++n) f.c[n] = (inverse_factorial[n - 2] - f.c[n - 2]) / s;
  }
  return f;
}

/// A function of s with its first two derivatives.
template <class T>
struct Jet {
  T f, d1, d2;
};

/// tan(y)/y of x = y^2, regular for y < pi/2.
template <class T>
Jet<T> tangent_quotient(const T& x) {
  const Stumpff<T> c = stumpff(x);
  const T h = c[1] / c[0];
  const T d = c.d1(1) / c[0];
  return {h, d + h * h / T(2), c.d2(1) / c[0] + T(3) * h * d / T(2) + h * h * h / T(2)};
}

/// kappa(s) = (1 - (phi/2) cot(phi/2))/phi^2, the [theta]^2 coefficient of Gamma^-1, for phi < 2 pi.
/// With x = s/4 it is (c2(x) - c3(x))/(4 c1(x)): the numerator is 1/3 at 0 and never cancels.
template <class T>
Jet<T> kappa(const T& s) {
  const Stumpff<T> c = stumpff(T(s / T(4)));
  const T n = (c[2] - c[3]) / c[1];
  const T n1 = (c.d1(2) - c.d1(3)) / c[1];
  const T n2 = (c.d2(2) - c.d2(3)) / c[1];
  return {n / T(4), (n1 / T(4) + n * n / T(8)) / T(4),
          (n2 / T(4) + T(3) * n * n1 / T(8) + n * n * n / T(8)) / T(16)};
}

}  // namespace halfway
