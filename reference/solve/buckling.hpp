// Static buckling of an angular joint under a fixed moment about one axis of node a [46].
#pragma once

#include "reference/face/registry.hpp"

#include <optional>

namespace halfway::reference {

struct Buckling {
  Real50 moment;  ///< about the axis, N m
  Real50 angle;   ///< rotation about the axis there, rad
};

/// The first zero of the determinant of the fixed-moment tangent along theta = angle * axis,
/// 0 < angle < pi, located to 45 digits; nothing when there is none. A pole (gimbal lock) is not a
/// zero. @param axis  0, 1 or 2; the law must have principal axes.
std::optional<Buckling> first_buckling(const Entry& entry, const JointSpec& spec, int axis);

}  // namespace halfway::reference
