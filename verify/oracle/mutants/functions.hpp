// Wrong twins of the functions of so3.hpp, as they stand in other programs or in first drafts.
#pragma once

#include "verify/oracle/so3_measure.hpp"

namespace halfway::verify::wrong {

/// The library's own functions, for the healthy run of the same measurement.
struct Gamma {
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& theta) {
    return so3::gamma(theta);
  }
};
struct Log {
  static constexpr Input input = Input::matrix;
  template <class T>
  static Vec3<T> apply(const Mat3<T>& R) {
    return so3::log(R);
  }
};

/// Gamma by its closed form down to phi = 1e-8; at 50 digits the same formula is right.
struct GammaLateThreshold {
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& theta) {
    using std::cos, std::sin, std::sqrt;
    if constexpr (std::is_same_v<T, Real50>) {
      return so3::gamma(theta);
    } else {
      const T s = theta.squaredNorm(), phi = sqrt(s);
      const bool small = phi < T(1e-8);
      const T b = small ? T(0.5) : (T(1) - cos(phi)) / s;
      const T c = small ? T(1) / T(6) : (phi - sin(phi)) / (s * phi);
      const Mat3<T> x = skew(theta);
      return Mat3<T>::Identity() + b * x + c * x * x;
    }
  }
};

/// Gamma whose short series has the wrong sign in its second term, 1/2 + phi^2/24 for 1/2 - phi^2/24 (as
/// Pinocchio's -1/2 - n^2/24), used as far as the right two terms are exact: phi^4/720 < eps.
struct GammaSeriesSign {
  static constexpr Input input = Input::rotation_vector;
  template <class T>
  static Mat3<T> apply(const Vec3<T>& theta) {
    if constexpr (!std::is_same_v<T, Real50>) {
      const T s = theta.squaredNorm();
      if (s < T(6.25e-6)) {
        const Mat3<T> x = skew(theta);
        return Mat3<T>::Identity() + (T(1) / T(2) + s / T(24)) * x + x * x / T(6);
      }
    }
    return so3::gamma(theta);
  }
};

/// log by phi/(2 sin phi) times the skew part: it loses the axis near pi.
struct LogBySine {
  static constexpr Input input = Input::matrix;
  template <class T>
  static Vec3<T> apply(const Mat3<T>& R) {
    using std::atan2, std::sqrt;
    if constexpr (!std::is_same_v<T, Real50>) {
      const Vec3<T> sine = axial(R);
      const T size = sine.norm();
      if (size > T(0)) return atan2(size, (R.trace() - T(1)) / T(2)) / size * sine;
    }
    return so3::log(R);
  }
};

}  // namespace halfway::verify::wrong
