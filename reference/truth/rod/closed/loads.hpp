// Critical loads of straight rods in closed form, or as zeros of a function that has one; at 50 digits where
// a zero has to be found.
#pragma once

#include "reference/truth/rod/critical.hpp"

namespace halfway::reference::rod::closed {

/// The torque that buckles a rod hinged at both ends under a thrust P < pi^2 B/L^2: M^2/(4 B^2) + P/B =
/// pi^2/L^2 (Greenhill, 1883).
double greenhill_hinged(double B, double length, double P);
/// Clamped at both ends: tan(M L/(2 B)) = M L/(2 B).
double greenhill_clamped(double B, double length);

/// The size of the determinant of the lateral directions of a rod under the torque M, clamped at one end, for
/// B = L = 1, as a complex number; derived here from the modes 1, s, s^2 and exp(i M s). The moduli of its
/// two terms are equal at M = 0 alone, so none of these ends lets a torque buckle the rod:
///   hinged, torque follower   ((1 + i M) - (1 + M^2/2) e^{i M})/(i M^3)
///   hinged, torque fixed      ((1 + M^2/2) - (1 - i M) e^{i M})/(i M^3)
///   free                      1
double torque_determinant(TorqueEnds ends, double M);

/// A semi-tangential torque on a free end, pi B/L, a double zero; and a quasi-tangential one, half of it
/// (Ziegler, 1952). Of a strip under a moment about its stiff, rigid axis the same with sqrt(EI2 GJ) for B.
double semi_tangential(double B, double length);
double quasi_tangential(double B, double length);

/// A strip between forks under a uniform moment about its stiff axis 3, bent by it before it buckles
/// (Michell, 1899; Reissner, 1904): (pi/L) sqrt(EI2 GJ/((1 - EI2/EI3)(1 - GJ/EI3))).
/// @param bending  (GJ, EI2, EI3), the first two below the third
double fork_strip(const Vec3<double>& bending, double length);

/// A strip with a rigid stiff axis under a dead force on the tip of a cantilever (Prandtl, 1899; Michell,
/// 1899): 2 j sqrt(EI2 GJ)/L^2, j the first zero of the Bessel function J_{-1/4}.
double tip_force(double EI2, double GJ, double length);

/// Beck's column (1952): EI = L = mass per length = 1.
/// P^2 + 2 w^2 (1 + cosh a cos b) + P w sinh a sin b, a^2 = r - P/2, b^2 = r + P/2, r^2 = P^2/4 + w^2.
double beck_determinant(double P, double w);

}  // namespace halfway::reference::rod::closed
