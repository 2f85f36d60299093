// Chains under a moment about axis 1 alone: every joint turns by the same angle, and what the tangent says
// there.
#pragma once

#include "reference/face/registry.hpp"

#include <optional>

namespace halfway::verify {

/// What the moment on the last node does when that turns by w: nothing, or half of w x m, which is
/// conservative.
enum class EndMoment { fixed, semi_tangential };

/// `links` angular joints of stiffness links K (K: GJ/L, EI2/L, EI3/L), clamped at the root, in balance with
/// every joint turned by `angle` about axis 1.
template <class T>
struct Twisted {
  T moment;       ///< on the last node, about axis 1, N m
  T determinant;  ///< of the tangent by the spins of nodes 1 ... links, over that at rest
};
template <class T>
Twisted<T> twisted(const reference::Entry& entry, const Vec3<double>& K, int links, const T& angle,
                   EndMoment end);

}  // namespace halfway::verify
