// Small changes of a loaded rod: what each end admits and demands, and the determinant of both, which
// vanishes where the rod has a second equilibrium next to its own, or a vibration of the frequency asked for.
#pragma once

#include "reference/truth/rod/flow.hpp"

#include <span>

namespace halfway::reference::rod {

inline constexpr int kFiner = 2;  ///< what is answered; its error is what enough_steps() alone change

/// One end of the rod, three columns or rows of its place, then three of its orientation, by global axes.
struct End {
  Eigen::Matrix<double, 12, 6> admitted;  ///< changes that an end at s = 0 allows
  Eigen::Matrix<double, 6, 12> demanded;  ///< of the changes at an end at s = length: has to vanish
};

/// How the moment on an end changes with the spin of the end, dm = A w. Moments in global axes, N m.
Mat3<double> of_fixed_moment();                          ///< 0
Mat3<double> of_follower_moment(const Vec3<double>& m);  ///< dm = w x m
/// dm = w x m/2, as increments at the state under m: conservative.
Mat3<double> of_semi_tangential_moment(const Vec3<double>& m);
/// Two dead forces on a rigid arm along q: dm = M p (q . w), p x q = m/M, as increments at the state under m.
/// p and q are unit vectors at right angles: conservative.
Mat3<double> of_quasi_tangential_moment(double M, const Vec3<double>& p, const Vec3<double>& q);

End clamped();
End hinged(const Mat3<double>& moment_by_spin);
/// @param force_by_spin  of a force that changes with the spin, dn = B w: -[n] of a follower
End free_end(const Mat3<double>& moment_by_spin, const Mat3<double>& force_by_spin = Mat3<double>::Zero());
/// Held in place, its section not free to twist; free to bend both ways without a moment along its axes 2 and
/// 3 but that of the state.
End fork(const State& at);

/// Of the changes with the places and orientations of `kept`: 0, 1, 2 place along global axes, 3, 4, 5
/// orientation about them. A problem that falls apart, as one of a plane state does, has a determinant for
/// each part.
double determinant(const End& start, const Changes& transfer, const End& end, std::span<const int> kept);

inline constexpr int kAll[] = {0, 1, 2, 3, 4, 5};
inline constexpr int kOutOfPlane[] = {2, 3, 4};  ///< of a state in the plane 1, 2

/// All changes at the clamp carried to the tip of a rod that carries n and m at the clamp.
/// @param finer  times enough_steps()
Arrival carried(const Rod& rod, const Vec3<double>& n, const Vec3<double>& m, int finer = kFiner,
                double inertia = 0);

}  // namespace halfway::reference::rod
