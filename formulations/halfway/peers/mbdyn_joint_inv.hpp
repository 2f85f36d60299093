// MBDyn "invariant deformable joint" as coded (1.7.3, vehj3.cc); its manual says otherwise.
//
// Defect, reproduced on purpose: strains are those of the half-way frame, but force and moment are
// projected with P_a, the frame of node a, before they reach the arms of the half-way form.
#pragma once

#include "halfway/systems/intrinsic.hpp"

namespace halfway {

struct MbdynJointInv {
  static constexpr const char* name = "mbdyn_joint_inv";
  static constexpr const char* stands_for = "MBDyn \"invariant deformable joint\" as coded";
  static constexpr Facts facts{
      .node_order = {.angular = near(0.607), .linear = near(0.763), .linear_angular = near(0.686)},
      .symmetry = {.angular = near(0.739), .linear = near(0.567), .linear_angular = near(0.655)},
      .loop_work = {.angular = near(0.151), .linear = near(0.0142), .linear_angular = near(0.168)},
      .loop_slope = 3,
      .clamped_energy = near(0.243),
      .alpha = 0};

  static constexpr bool kLinearWithoutRotation = false;
  static constexpr bool has_potential(Kind) { return false; }

  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    return Invariant{}.template strain<kind>(m);
  }

  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    const LawResponse<T, 3> response = law(m.theta);
    AngularResponse<T> r;
    r.m = response.stress;
    if constexpr (with_tangent) r.m_psi = response.stiffness * so3::gamma_inverse(m.theta);
    return r;
  }

  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    constexpr bool kAngular = kind == Kind::linear_angular;
    const FrameHalfway frame;
    const LawResponse<T, strain_count(kind)> response = law(strain<kind>(m));
    PointResponse<T> r;
    r.f = response.stress.template head<3>();
    const Vec3<T> moment = m.p.cross(r.f);
    const Mat3<T> At = frame.spin(m).transpose();
    r.m_b = -(At * moment);
    if constexpr (kAngular) r.m_b += response.stress.template tail<3>();
    if constexpr (with_tangent) {
      const Mat3<T> E = so3::gamma_inverse(m.theta);
      const Isotropic<T> M = frame.motion(T(m.theta.squaredNorm()));
      const Mat3<T> J = M.matrix(m.theta);  // d(dbar) = J dp + N psi, d(theta) = E psi
      const Mat3<T> N = M.derivative(m.theta, m.p) * E;
      const Mat3<T> K_ff = response.stiffness.template topLeftCorner<3, 3>();
      r.f_p = K_ff * J;
      r.f_psi = K_ff * N;
      if constexpr (kAngular) r.f_psi += response.stiffness.template topRightCorner<3, 3>() * E;
      r.m_b_p = At * (skew(r.f) - skew(m.p) * r.f_p);
      r.m_b_psi = -At * skew(m.p) * r.f_psi - FrameHalfway::spin_transposed_rate(m, moment);
      if constexpr (kAngular) {
        const Mat3<T> K_mf = response.stiffness.template bottomLeftCorner<3, 3>();
        const Mat3<T> K_mm = response.stiffness.template bottomRightCorner<3, 3>();
        r.m_b_p += K_mf * J;
        r.m_b_psi += K_mf * N + K_mm * E;
      }
      balance_moment(m, r);
    } else {
      r.m_a = -(r.m_b + moment);
    }
    return r;
  }
};

}  // namespace halfway
