// Scalars, small matrices and the skew operator shared by every header of the library.
#pragma once

#include "halfway/rotations/cpp20.hpp"

#include <Eigen/Geometry>

#include <limits>

namespace halfway {

template <class T>
using Vec3 = Eigen::Matrix<T, 3, 1>;
template <class T>
using Mat3 = Eigen::Matrix<T, 3, 3>;

/// [v], the matrix with [v] w = v x w.
template <class T>
Mat3<T> skew(const Vec3<T>& v) {
  Mat3<T> m;
  m << T(0), -v[2], v[1], v[2], T(0), -v[0], -v[1], v[0], T(0);
  return m;
}

/// The vector of the skew part of m: axial(skew(v)) == v.
template <class T>
Vec3<T> axial(const Mat3<T>& m) {
  return Vec3<T>(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1)) / T(2);
}

/// Binary digits of the significand of T; a dual number has those of its value.
/// Specialise for scalars that std::numeric_limits does not know.
template <class T>
struct RealDigits {
  static constexpr int value = std::numeric_limits<T>::digits;
};

}  // namespace halfway
