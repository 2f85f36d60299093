// Work round closed loops.
#include "verify/oracle/measures.hpp"

#include <Eigen/LU>

#include <cmath>

namespace halfway::verify {
namespace {

using V50 = Vec3<Real50>;
using M50 = Mat3<Real50>;

V50 triple(double x, double y, double z) { return {Real50(x), Real50(y), Real50(z)}; }

/// A smooth closed curve and its rate, without any symmetry.
struct Curve {
  V50 value, rate;
};
Curve curve(const Real50& t, const V50& c1, const V50& s1, const V50& c2, const V50& s2) {
  const Real50 two(2);
  return {c1 * cos(t) + s1 * sin(t) + c2 * cos(two * t) + s2 * sin(two * t),
          -c1 * sin(t) + s1 * cos(t) - two * c2 * sin(two * t) + two * s2 * cos(two * t)};
}

}  // namespace

LoopWork loop_work(const JointUnderTest& joint, const JointSpec& spec, double amplitude, int points) {
  const Real50 size(amplitude), step = Real50(2) * reference::pi50() / Real50(points);
  const JointEnd<Real50> end_a{spec.a.o.cast<Real50>(), spec.a.H.cast<Real50>()};
  const JointEnd<Real50> end_b{spec.b.o.cast<Real50>(), spec.b.H.cast<Real50>()};
  const Pose<Real50> a = exact_pose({}, spec.a);
  const M50 P_a = a.R * end_a.H, H_b_inverse = end_b.H.inverse();
  LoopWork work{Real50(0), Real50(0)};
  for (int i = 0; i < points; ++i) {
    const Real50 t = Real50(i) * step;
    const Curve angle = curve(t, size * triple(1, 0.31, -0.47), size * triple(-0.23, 0.9, 0.37),
                              size * triple(0.11, -0.29, 0.53), size * triple(0.41, 0.17, 0.67));
    const Curve place = curve(t, size * triple(0.43, -0.8, 0.19), size * triple(0.71, 0.13, -0.61),
                              size * triple(-0.37, 0.23, 0.07), size * triple(0.05, 0.59, 0.29));
    const V50 spin = P_a * so3::gamma(angle.value) * angle.rate;
    Pose<Real50> b;
    b.R = P_a * so3::exp(angle.value) * H_b_inverse;
    const V50 arm_b = b.R * end_b.o;
    b.x = a.x + a.R * end_a.o + P_a * place.value - arm_b;
    const V50 rate_x = P_a * place.rate - spin.cross(arm_b);
    const auto q = joint.loads(spec, a, b, false).q;
    const Real50 power = q.segment<3>(6).dot(rate_x) + q.segment<3>(9).dot(spin);
    work.net += power * step;
    work.turnover += abs(power) * step;
  }
  return work;
}

}  // namespace halfway::verify
