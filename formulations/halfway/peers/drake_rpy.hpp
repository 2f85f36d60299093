// Drake LinearBushingRollPitchYaw: roll-pitch-yaw torque, half-way force at the midpoint.
//
// Defects, reproduced on purpose: the force acts at the midpoint of p_a p_b, which is conjugate to
// w/2 and not to the true rate of the half-way frame, so force and moment have no common potential;
// the Euler sequence makes the torque depend on the order of the nodes; gimbal lock at |pitch| = pi/2.
#pragma once

#include "halfway/systems/euler.hpp"

namespace halfway {

struct DrakeRpy {
  static constexpr const char* name = "drake_rpy";
  static constexpr const char* stands_for = "Drake LinearBushingRollPitchYaw";
  static constexpr bool kBlockDiagonalLawOnly = true;
  static constexpr Facts facts{.node_order = {.angular = near(0.793), .linear_angular = near(0.599)},
                               .symmetry = {.linear = near(0.0458), .linear_angular = near(0.0279)},
                               .loop_work = {.linear = near(0.00236), .linear_angular = near(0.00229)},
                               .loop_slope = 4,
                               .beta = 0.5};

  /// The torque alone derives from a potential; the midpoint force does not.
  static constexpr bool kLinearWithoutRotation = false;
  static constexpr bool has_potential(Kind kind) { return kind == Kind::angular; }

  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    return Equivalent{}.template strain<kind>(m);
  }

  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    return Equivalent{}.template angular<with_tangent>(m, law);
  }

  /// As the conjugate joint, but with the arm -p/2 in place of -I^(1/2)^T [p].
  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    const FrameHalfway frame;
    PointResponse<T> r = Equivalent{}.template point<kind, with_tangent>(m, law);
    const Vec3<T> moment = m.p.cross(r.f);
    const Mat3<T> S = frame.spin(m).transpose() - Mat3<T>::Identity() / T(2);  // ([z])/2
    r.m_b += S * moment;
    if constexpr (with_tangent) {
      r.m_b_p += S * (skew(m.p) * r.f_p - skew(r.f));
      r.m_b_psi += S * skew(m.p) * r.f_psi + FrameHalfway::spin_transposed_rate(m, moment);
      balance_moment(m, r);
    } else {
      r.m_a = -(r.m_b + moment);
    }
    return r;
  }

 private:
  using Equivalent = Family<FrameHalfway, Euler321, Conjugate>;
};

}  // namespace halfway
