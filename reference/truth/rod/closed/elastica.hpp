// Euler's elastica, an inextensible rod that bends in one plane, by elliptic integrals.
#pragma once

namespace halfway::reference::rod::closed {

/// The tip of a cantilever of length 1; x is along the tangent at the clamp.
struct Elastica {
  double angle;  ///< rad
  double x, y;
};

/// Under a dead force P at right angles to the tangent at the clamp, towards +y (Bisshopp and Drucker, 1945).
/// @param alpha  P L^2/EI > 0, up to some 50: the angle then is a right one but for rounding. Good to 1e-14.
Elastica under_transverse_force(double alpha);

/// Buckled towards +y by a dead thrust P along the tangent at the clamp (Euler, 1744; Love, 1892).
/// @param alpha  P L^2/EI > pi^2/4, up to some 50. Good to 1e-14.
Elastica under_thrust(double alpha);

}  // namespace halfway::reference::rod::closed
