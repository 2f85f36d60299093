// Joints as files have them, in double, taken into another scalar; and by their kind.
#pragma once

#include "halfway/joint.hpp"

#include <type_traits>

namespace halfway::reference {

/// Frames are orthonormal in double; where that is no rounding, the nearest rotation.
template <class T>
Mat3<T> rotation_in(const Mat3<double>& H) {
  if constexpr (std::is_same_v<T, double>)
    return H;
  else
    return so3::matrix<T>(so3::quaternion<T>(Mat3<T>(H.template cast<T>())));
}

template <class T>
JointEnd<T> end_in(const JointEnd<double>& end) {
  return {end.o.template cast<T>(), rotation_in<T>(end.H)};
}

/// fn(std::integral_constant<Kind, kind>{})
template <class Fn>
auto by_kind(Kind kind, Fn&& fn) {
  switch (kind) {
    case Kind::angular:
      return fn(std::integral_constant<Kind, Kind::angular>{});
    case Kind::linear:
      return fn(std::integral_constant<Kind, Kind::linear>{});
    default:
      return fn(std::integral_constant<Kind, Kind::linear_angular>{});
  }
}

}  // namespace halfway::reference
