// Places of joints on bodies, as files give them: angles in sequences, frames in frames.
#pragma once

#include "halfway/joint.hpp"

#include <array>
#include <numbers>

namespace halfway::imports {

/// Where a frame is in another: point (m) and axes, as of a joint's end.
using Frame = JointEnd<double>;

inline constexpr double kDegree = std::numbers::pi / 180;  // rad

/// About axis 0, 1 or 2 by an angle, rad. Nothing turns exactly.
Mat3<double> turn(int axis, double angle);

/// About the axes of the body in turn: turn(axes[0]) turn(axes[1]) turn(axes[2]).
Mat3<double> turns(const std::array<int, 3>& axes, const Vec3<double>& angles);

/// The angles, rad, of which turns({0, 1, 2}, angles) is R; the first is zero where the second is a right
/// angle.
Vec3<double> angles_xyz(const Mat3<double>& R);

/// B, given in frame A, seen from where A is given.
Frame in_frame(const Frame& A, const Frame& B);
Frame inverse(const Frame& A);

}  // namespace halfway::imports
