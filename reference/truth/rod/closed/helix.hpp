// Helices: the states of a rod with EI2 = EI3 = B and GJ = C that need no integration (Kirchhoff, 1859).
#pragma once

#include "reference/truth/rod/rod.hpp"

namespace halfway::reference::rod::closed {

/// The tip of a straight, inextensible rod under a fixed end moment m: a helix about m,
///   R = exp(m L/B) exp((1/C - 1/B) m_1 L e_1),  x = L Gamma(m L/B) e_1.
/// The section turns about m as that of a rod with C = B would, and about its own tangent by the rest;
/// derived here.
Tip under_moment(double B, double C, double length, const Vec3<double>& m);

/// A straight, inextensible rod wound to a helix.
struct Helix {
  double B, C;    ///< N m^2
  double radius;  ///< m
  double pitch;   ///< the angle of the tangent to the plane across the axis, rad
  double twist;   ///< of the section about the tangent by arc length, the helix' own torsion included, rad/m
};

/// The wrench along the axis that holds it (Love, 1892): force (C twist cos a - B sin a cos^2 a/r)/r,
/// positive where it pulls, couple C twist sin a + B cos^3 a/r; a the pitch, r the radius.
struct Wrench {
  double force, couple;  ///< N, N m
};
Wrench wrench_of(const Helix& helix);

/// A section of it at arc length s and what acts across it there. At s = 0 it is the clamp of rod.hpp with
/// the axis of the helix in the plane 1, 3 on the side of +2.
struct HelixState {
  Vec3<double> x, n, m;
  Mat3<double> R;
};
HelixState along(const Helix& helix, double s);

}  // namespace halfway::reference::rod::closed
