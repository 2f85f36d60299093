#include "reports/import/record/frames.hpp"

#include <cmath>

namespace halfway::imports {

Mat3<double> turn(int axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const int j = (axis + 1) % 3, k = (axis + 2) % 3;
  Mat3<double> R = Mat3<double>::Identity();
  R(j, j) = R(k, k) = c;
  R(k, j) = s;
  R(j, k) = -s;
  return R;
}

Mat3<double> turns(const std::array<int, 3>& axes, const Vec3<double>& angles) {
  return turn(axes[0], angles[0]) * turn(axes[1], angles[1]) * turn(axes[2], angles[2]);
}

Vec3<double> angles_xyz(const Mat3<double>& R) {
  const double across = std::hypot(R(1, 2), R(2, 2));  // the cosine of the second angle
  if (across < 1e-15) return {0, std::atan2(R(0, 2), across), std::atan2(R(1, 0), R(1, 1))};
  return {std::atan2(-R(1, 2), R(2, 2)), std::atan2(R(0, 2), across), std::atan2(-R(0, 1), R(0, 0))};
}

Frame in_frame(const Frame& A, const Frame& B) { return {A.o + A.H * B.o, A.H * B.H}; }

Frame inverse(const Frame& A) { return {-(A.H.transpose() * A.o), A.H.transpose()}; }

}  // namespace halfway::imports
