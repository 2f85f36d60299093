// Static buckling of an angular joint under a fixed moment about one of its own axes [46].
#pragma once

#include "reference/face/registry.hpp"

#include <optional>

namespace halfway::reference {

struct Buckling {
  Real50 moment;  ///< about the axis, N m
  Real50 angle;   ///< rotation about the axis from the unstrained pose, rad
};

/// The first zero of the determinant of the fixed-moment tangent on the way of the loaded node round a joint
/// axis, 0 < angle < pi from the unstrained pose, located to 45 digits; nothing when there is none. A pole
/// (gimbal lock) is not a zero. @param axis  0, 1 or 2; must be a principal axis of the law.
/// @param nodes_exchanged  the clamped node, whose end is spec.a, is listed as b.
std::optional<Buckling> first_buckling(const Entry& entry, const JointSpec& spec, int axis,
                                       bool nodes_exchanged = false);

}  // namespace halfway::reference
