// Chrono ChLoadBodyBodyBushingGeneric: law in the frame of body b.
//
// Defect, reproduced on purpose: force and moment are applied with opposite sign at the two joint
// points, without the arm p x f, so the moments on the two bodies do not balance.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

struct ChronoBody {
  static constexpr const char* name = "chrono_body";
  static constexpr const char* stands_for = "Chrono ChLoadBodyBodyBushingGeneric";
  static constexpr Facts facts{
      .moment_balance = {.linear = near(0.333), .linear_angular = near(0.186)},
      .node_order = {.angular = near(0.607), .linear = near(0.651), .linear_angular = near(2.19)},
      .symmetry = {.angular = near(0.682), .linear = near(0.546), .linear_angular = near(0.63)},
      .loop_work = {.angular = near(0.19), .linear = near(0.0524), .linear_angular = near(0.19)},
      .loop_slope = 3,
      .clamped_energy = near(0.3636),
      .alpha = 1};

  static constexpr bool kLinearWithoutRotation = false;
  static constexpr bool has_potential(Kind) { return false; }

  /// (P_b^T (p_a - p_b), log(P_b^T P_a)): the motion of a seen from b.
  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    if constexpr (kind == Kind::angular) {
      return -m.theta;
    } else if constexpr (kind == Kind::linear) {
      return -(m.R.transpose() * m.p);
    } else {
      Strain<T, kind> e;
      e << strain<Kind::linear>(m), strain<Kind::angular>(m);
      return e;
    }
  }

  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    const LawResponse<T, 3> response = law(strain<Kind::angular>(m));
    AngularResponse<T> r;
    r.m = -(m.R * response.stress);
    if constexpr (with_tangent) r.m_psi = m.R * response.stiffness * so3::gamma_inverse(m.theta) - skew(r.m);
    return r;
  }

  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    constexpr bool kAngular = kind == Kind::linear_angular;
    const LawResponse<T, strain_count(kind)> response = law(strain<kind>(m));
    const Mat3<T> O = Mat3<T>::Zero();
    PointResponse<T> r;
    r.f = -(m.R * response.stress.template head<3>());
    r.m_b = Vec3<T>::Zero();
    if constexpr (kAngular) r.m_b = -(m.R * response.stress.template tail<3>());
    if constexpr (with_tangent) {
      const Mat3<T> J = m.R.transpose();  // d(-strain) = J dp + N psi, and E psi
      const Mat3<T> N = J * skew(m.p);
      const Mat3<T> K_ff = response.stiffness.template topLeftCorner<3, 3>();
      r.f_p = m.R * K_ff * J;
      r.f_psi = m.R * K_ff * N - skew(r.f);
      r.m_b_p = r.m_b_psi = O;
      if constexpr (kAngular) {
        const Mat3<T> E = so3::gamma_inverse(m.theta);
        const Mat3<T> K_fm = response.stiffness.template topRightCorner<3, 3>();
        const Mat3<T> K_mf = response.stiffness.template bottomLeftCorner<3, 3>();
        const Mat3<T> K_mm = response.stiffness.template bottomRightCorner<3, 3>();
        r.f_psi += m.R * K_fm * E;
        r.m_b_p = m.R * K_mf * J;
        r.m_b_psi = m.R * (K_mf * N + K_mm * E) - skew(r.m_b);
      }
      r.m_a_p = -r.m_b_p;
      r.m_a_psi = -r.m_b_psi;
    }
    r.m_a = -r.m_b;
    return r;
  }
};

}  // namespace halfway
