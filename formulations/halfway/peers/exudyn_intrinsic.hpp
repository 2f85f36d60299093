// Exudyn RigidBodySpringDamper with intrinsicFormulation: SE(3) logarithm in the half-way frame.
//
// Defects, reproduced on purpose: the stresses K (v, theta) are applied directly and not through
// the transposed rate of the logarithm, so they have no potential; the arm is -v/2 and not half the
// chord, with the same sign on both nodes, so the moments do not balance exactly.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

struct ExudynIntrinsic {
  static constexpr const char* name = "exudyn_intrinsic";
  static constexpr const char* stands_for = "Exudyn RigidBodySpringDamper, intrinsicFormulation";
  static constexpr Facts facts{
      .moment_balance = {.linear = near(0.00443), .linear_angular = near(0.00142)},
      .symmetry = {.angular = near(0.0558), .linear = near(0.0493), .linear_angular = near(0.0958)},
      .loop_work = {.angular = near(0.000307), .linear = near(0.000191), .linear_angular = near(0.00167)},
      .loop_slope = 4,
      .clamped_energy = near(0.005231)};

  static constexpr bool kLinearWithoutRotation = false;
  static constexpr bool has_potential(Kind) { return false; }

  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    return Equivalent{}.template strain<kind>(m);
  }

  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    return Equivalent{}.template angular<with_tangent>(m, law);
  }

  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    constexpr bool kAngular = kind == Kind::linear_angular;
    const FrameHalfway frame;
    const Mat3<T> Q = frame.rotation(m);
    const Strain<T, kind> e = strain<kind>(m);
    const LawResponse<T, strain_count(kind)> response = law(e);
    const Vec3<T> arm = Q * e.template head<3>() / T(-2);
    PointResponse<T> r;
    r.f = Q * response.stress.template head<3>();
    const Vec3<T> couple = arm.cross(r.f);
    Vec3<T> moment = Vec3<T>::Zero();
    if constexpr (kAngular) moment = Q * response.stress.template tail<3>();
    if constexpr (with_tangent) {
      const Mat3<T> J = so3::gamma_inverse(m.theta);  // d(v) = J dp + N psi, d(theta) = J psi
      const Mat3<T> N = so3::gamma_inverse_isotropic(T(m.theta.squaredNorm())).derivative(m.theta, m.p) * J;
      const Mat3<T> spin = frame.spin(m);
      const Mat3<T> QK_ff = Q * response.stiffness.template topLeftCorner<3, 3>();
      r.f_p = QK_ff * J;
      r.f_psi = QK_ff * N - skew(r.f) * spin;
      Mat3<T> moment_p = Mat3<T>::Zero(), moment_psi = Mat3<T>::Zero();
      if constexpr (kAngular) {
        const Mat3<T> QK_fm = Q * response.stiffness.template topRightCorner<3, 3>();
        const Mat3<T> QK_mf = Q * response.stiffness.template bottomLeftCorner<3, 3>();
        const Mat3<T> QK_mm = Q * response.stiffness.template bottomRightCorner<3, 3>();
        r.f_psi += QK_fm * J;
        moment_p = QK_mf * J;
        moment_psi = QK_mf * N + QK_mm * J - skew(moment) * spin;
      }
      const Mat3<T> arm_p = Q * J / T(-2);
      const Mat3<T> arm_psi = Q * N / T(-2) - skew(arm) * spin;
      const Mat3<T> couple_p = skew(arm) * r.f_p - skew(r.f) * arm_p;
      const Mat3<T> couple_psi = skew(arm) * r.f_psi - skew(r.f) * arm_psi;
      r.m_a_p = couple_p - moment_p;
      r.m_a_psi = couple_psi - moment_psi;
      r.m_b_p = couple_p + moment_p;
      r.m_b_psi = couple_psi + moment_psi;
    }
    r.m_a = couple - moment;
    r.m_b = couple + moment;
    return r;
  }

 private:
  using Translational = Family<Se3Translation, RotationVectorMeasure, Conjugate>;
  /// Same strains as the helicoidal joint; as an angular joint it is the invariant one.
  struct Equivalent : Family<FrameHalfway, RotationVectorMeasure, Projected> {
    template <Kind kind, class T>
    Strain<T, kind> strain(const RelativeMotion<T>& m) const {
      return Translational{}.template strain<kind>(m);
    }
  };
};

}  // namespace halfway
