// The rod's equations as a flow from the clamp along s, with small changes carried along: what shooting, the
// determinants of stability and the rod in vibration share.
#pragma once

#include "reference/truth/rod/rod.hpp"

namespace halfway::reference::rod {

/// A section and what acts across it, in global axes.
struct State {
  Vec3<double> x{0, 0, 0};                    ///< m
  Mat3<double> R = Mat3<double>::Identity();  ///< section -> global
  Vec3<double> m{0, 0, 0};                    ///< N m
};

/// Small changes of a state, a column each: dx, w (the spin: dR = [w] R), dm, dn; three rows each, global
/// axes.
using Changes = Eigen::Matrix<double, 12, Eigen::Dynamic, 0, 12, 12>;
inline constexpr int kX = 0, kSpin = 3, kMoment = 6, kForce = 9;

/// Where the flow arrives, and what has become of the changes at its start.
struct Arrival {
  State end;
  Changes changes;
};

/// From `start` at s = 0 to the end of the rod in `steps` equal steps of GSL's Runge-Kutta pair of order 8.
/// The force n is the same all along. The changes obey the variational equations
///   dx' = w x x' + R C_n R^T (dn + n x w),  w' = R C_m R^T (dm + m x w),  dm' = dn x x' + n x dx',
///   dn' = -inertia dx
/// @param inertia  mass per length times the square of the circular frequency, N/m^2: 0 of what is at rest
Arrival flow(const Rod& rod, const State& start, const Vec3<double>& n, const Changes& changes, int steps,
             double inertia = 0);

/// So many steps that each turns the section, or bends its path, by some 1/5: the error is then at rounding.
int enough_steps(const Rod& rod, const State& start, const Vec3<double>& n);

/// The section at s, 0 <= s <= length.
Section section_at(const Rod& rod, double s);

}  // namespace halfway::reference::rod
