#include "reference/truth/rod/closed/helix.hpp"

#include "halfway/rotations/so3.hpp"

#include <cmath>

namespace halfway::reference::rod::closed {

Tip under_moment(double B, double C, double length, const Vec3<double>& m) {
  const Vec3<double> turn = length / B * m;
  const Vec3<double> rest((1 / C - 1 / B) * m[0] * length, 0, 0);
  return {length * so3::gamma(turn).col(0), so3::exp(turn) * so3::exp(rest)};
}

Wrench wrench_of(const Helix& h) {
  const double c = std::cos(h.pitch), s = std::sin(h.pitch), r = h.radius;
  return {(h.C * h.twist * c - h.B * s * c * c / r) / r, h.C * h.twist * s + h.B * c * c * c / r};
}

HelixState along(const Helix& h, double s) {
  const double c = std::cos(h.pitch), sine = std::sin(h.pitch);
  const Vec3<double> axis(sine, 0, c), to_axis(0, h.radius, 0);
  // The tangent turns about the axis by c/r per arc length; Frenet's frame twists by sine c/r of that.
  const Mat3<double> turned = so3::exp<double>(s * c / h.radius * axis);
  const Vec3<double> own((h.twist - sine * c / h.radius) * s, 0, 0);
  const Wrench w = wrench_of(h);
  HelixState out;
  out.R = turned * so3::exp(own);
  const Vec3<double> arm = turned * to_axis;  // from the section to the axis
  out.x = to_axis - arm + s * sine * axis;
  out.n = w.force * axis;
  out.m = w.couple * axis + arm.cross(out.n);
  return out;
}

}  // namespace halfway::reference::rod::closed
