// The functions of an angle that the kernels need, without trigonometry, square root or branch.
//
// With the relative quaternion (w, v), w >= 0 and t = 1 - w in [0, 1]: theta = h(t) v. Its derivatives
// give every rate. Double: a polynomial for h, from which the derivatives follow; more digits: the
// hypergeometric series of h.
#pragma once

#include "halfway/kernels/core/coefficients.hpp"
#include "halfway/kernels/core/scalar.hpp"

namespace halfway::kernel {

/// phi = h sin(phi/2) and its derivatives by w = cos(phi/2): d = -h'/2, d1 = d', d2 = d''. Only what
/// `order` asks for is computed: 0: h; 1: and d; 2: and d1; 3: and d2.
template <class T>
struct AngleJet {
  T h, d, d1, d2;
};

/// Where a jet is asked for: t = 1 - w without cancellation, w, and iw = 1/(1 + w).
template <class T>
struct HalfAngle {
  T t, w, iw;
};

namespace detail {

/// The jet of h = 2 + t p, p = 2/3 + t q, q = 4/15 + t r; read: p for order 0 and 1, q for 2, r for 3.
/// Derivatives of (1 - w^2) h_w = w h - 2, divided by t in closed form: nothing cancels.
template <int order, class T>
HALFWAY_INLINE AngleJet<T> jet_of(const HalfAngle<T>& x, const T& p, const T& q, const T& r) {
  const T& w = x.w;
  const T two(2), ww = w * w, iw2 = x.iw * x.iw;
  AngleJet<T> j{};
  j.h = two + x.t * p;
  if constexpr (order >= 1) j.d = x.iw * (T(1) - T(0.5) * (w * p));
  if constexpr (order >= 2) j.d1 = -iw2 * (T(2. / 3) * (T(1) + x.t) + q * (T(0.5) + ww));
  if constexpr (order >= 3)
    j.d2 = iw2 * x.iw * (T(4) - T(1.2) * w + T(0.8) * ww - w * (T(4.5) + T(3) * ww) * r);
  return j;
}

}  // namespace detail

/// As exact as the scalar.
struct ExactAngle {
  template <int order, class T>
  static HALFWAY_INLINE AngleJet<T> jet(const HalfAngle<T>& x) {
    if constexpr (!kPolynomials<T>) {
      return series(x.t);
    } else if constexpr (constexpr int degree = kSingle<T> ? 9 : 20; order <= 1) {
      return detail::jet_of<order>(x, polynomial(detail::kAngleFrom1<degree>, x.t), {}, {});
    } else {
      const T r = polynomial(detail::kAngleFrom3<degree>, x.t);
      const T q = T(4. / 15) + x.t * r;
      return detail::jet_of<order>(x, T(2. / 3) + x.t * q, q, r);
    }
  }

 private:
  /// h = 2 sum_k (2^2k (k!)^2 / (2k + 1)!) (t/2)^k: half a bit or more a term for phi <= pi.
  template <class T>
  static AngleJet<T> series(const T& t) {
    constexpr int kTerms = Digits<T>::value + 40;  // the derivatives multiply terms by k^3
    T h(0), h1(0), h2(0), h3(0), c(2);
    T c_of[kTerms];
    for (int k = 0; k < kTerms; ++k) {
      c_of[k] = c;
      c = c * T(k + 1) / T(2 * k + 3);  // (2k+2)/(2k+3), and 1/2 of t/2
    }
    for (int k = kTerms - 1; k >= 0; --k) {  // Horner with derivatives
      h3 = h3 * t + h2;
      h2 = h2 * t + h1;
      h1 = h1 * t + h;
      h = h * t + c_of[k];
    }
    return {h, h1 / T(2), -h2, T(3) * h3};  // h2, h3 are h''/2, h'''/6
  }
};

namespace detail {
/// Polynomial and half its derivative, by Horner: tangent and residual of a truncated measure agree.
template <int order, int count, class T>
HALFWAY_INLINE AngleJet<T> truncated(const double (&c)[count], const T& t) {
  static_assert(order <= 1, "truncated measures have a first derivative only");
  AngleJet<T> j{};
  if constexpr (order == 0) {
    j.h = polynomial(c, t);
  } else {
    T h = T(c[count - 1]), h1 = T(0);
    for (int k = count - 2; k >= 0; --k) {
      h1 = h1 * t + h;
      h = h * t + T(c[k]);
    }
    j.h = h;
    j.d = h1 * T(0.5);
  }
  return j;
}
inline constexpr double kSmallAngle[3] = {2., 2. / 3., 4. / 15.};
}  // namespace detail

/// A polynomial of lower degree, with relative error kBound for every phi <= pi.
template <int degree>
struct PolynomialAngle {
  template <int order, class T>
  static HALFWAY_INLINE AngleJet<T> jet(const HalfAngle<T>& x) {
    return detail::truncated<order>(detail::kAngle<degree>, x.t);
  }
};

/// The first `terms` terms at phi = 0: relative error below (phi/pi)^(2 terms) / 2.
template <int terms>
struct SmallAngle {
  template <int order, class T>
  static HALFWAY_INLINE AngleJet<T> jet(const HalfAngle<T>& x) {
    if constexpr (terms == 1) {
      return {T(2), T(0), T(0), T(0)};
    } else {
      double c[terms];
      for (int k = 0; k < terms; ++k) c[k] = detail::kSmallAngle[k];
      return detail::truncated<order>(c, x.t);
    }
  }
};

/// s = sin(x)/x of y = x^2, s1 = ds/dy, s2 = (s - 1)/y, and c = cos(x), for |x| <= pi/2.
template <class T>
struct SineJet {
  T s, s1, s2, c;
};

template <class T>
HALFWAY_INLINE SineJet<T> sine_jet(const T& y) {
  SineJet<T> j;
  if constexpr (kPolynomials<T>) {
    j.s1 = polynomial(detail::kSine1 < kSingle<T> ? 5 : 8 >, y);
    j.s2 = polynomial(detail::kSine < kSingle<T> ? 5 : 8 >, y);
  } else {
    j.s1 = j.s2 = T(0);
    T term(1);  // (-y)^(k-1) / (2k - 1)!
    for (int k = 1; k < 40; ++k) {
      const T over = term / T((2 * k) * (2 * k + 1));
      j.s1 = j.s1 - T(k) * over;
      j.s2 = j.s2 - over;
      term = -(y * over);
    }
  }
  j.s = T(1) + y * j.s2;
  j.c = j.s + T(2) * (y * j.s1);
  return j;
}

/// Angle of (x, y) in (-pi, pi], without a branch; y = x = 0 gives 0.
template <class T>
HALFWAY_INLINE T angle_of(const T& y, const T& x) {
  using std::atan2, std::sqrt;
  if constexpr (kPolynomials<T>) {
    const T ax = x * sign_of(x), ay = y * sign_of(y);
    const T u = ay / (sqrt(x * x + y * y) + ax + tiny<T>());  // tan of half the angle to the x axis
    const T a = T(2) * u * polynomial(detail::kArctangent < kSingle<T> ? 9 : 20 >, u * u);
    const T pi = T(3.14159265358979323846);
    return sign_of(y) * where_negative(x, pi - a, a);
  } else {
    return atan2(y, x);
  }
}

}  // namespace halfway::kernel
