// Critical loads of rods: where the determinant of the changes that the ends admit first vanishes. Each is of
// the equilibrium as it is, bent before it buckles, unless the section is rigid against that.
#pragma once

#include "reference/truth/rod/stability.hpp"

#include <complex>

namespace halfway::reference::rod {

/// The ends of a straight rod that carries a torque and a thrust. The torque keeps its direction (fixed) or
/// turns with the end (follower); the thrust keeps its own.
enum class TorqueEnds {
  hinged_fixed,          ///< both ends, free to bend
  hinged_follower,       ///< both ends, free to bend
  clamped,               ///< both ends
  clamped_hinged_fixed,  ///< clamped at s = 0, as those that follow
  clamped_hinged_follower,
  clamped_free_fixed,
  clamped_free_follower
};

/// The first load of its kind, and what half the steps of the integration change of it; N or N m.
struct Critical {
  double load, error;
};

/// The determinant of a straight rod with EI2 = EI3 under a torque M and a thrust P, its two lateral
/// directions as one complex number: (2) + i (3). It needs no more than that to vanish, and has a zero where
/// the determinant of all directions, its square, has a double one.
std::complex<double> torque_determinant(const Rod& rod, TorqueEnds ends, double M, double P,
                                        int finer = kFiner);

/// The first torque between `low` and `high` at which it vanishes, to rounding; NaN where it does not.
Critical critical_torque(const Rod& rod, TorqueEnds ends, double P, double low, double high);

/// The first conservative moment below `high` about `axis` (0, 1, 2), alone on the tip, at which the smallest
/// stiffness of the tip against turns about the other two vanishes. A double zero changes its sign as well.
/// @param high  N m; the flexibility of the tip has to be regular up to there
Critical critical_semi_tangential(const Rod& rod, int axis, double high);
/// @param arm  of the dead forces, a unit vector at right angles to the axis
Critical critical_quasi_tangential(const Rod& rod, int axis, const Vec3<double>& arm, double high);

/// The first moment about axis 3, uniform along the rod between forks, at which it twists out of the plane.
/// At pi EI3/length, where it is half a circle, forks let it turn about its chord whatever it is made of.
Critical critical_fork_moment(const Rod& rod, double high);

/// The first dead force along axis 2 on the tip, at which the rod, bent by it, twists out of the plane 1, 2.
Critical critical_tip_force(const Rod& rod, double high);

/// Where two frequencies meet.
struct Flutter {
  double load, frequency;  ///< N, rad/s
  double error = 0;        ///< of both, relative: what half the steps of the integration change
};

/// The follower thrust on the tip of a straight rod of uniform mass per length, kg/m, at which its first two
/// frequencies in the plane 1, 2 meet.
/// @param near  from which Newton starts
Flutter follower_flutter(const Rod& rod, double mass_per_length, Flutter near);
/// The same of any determinant (load, frequency), which has a double zero there.
Flutter flutter(const std::function<double(double, double)>& determinant, Flutter near);

}  // namespace halfway::reference::rod
