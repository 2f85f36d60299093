// Kelvin-Voigt damping: stresses from the rates of the very strains that the elastic law sees.
//
// The rates are objective: p' is the rate of the relative position as node a's joint frame sees it, psi the
// relative spin in its axes, so that two bodies that move as one rigid body strain nothing, whatever their
// spin, their distance and the arms. The loads go back to the nodes by the transport of the elastic ones. By
// the conjugate transport the power taken out is exactly e'. C e'; by a projected one it is that only where
// the frame's axes and the strain's rate agree, and no law C makes it positive for every motion.
#pragma once

#include "halfway/joint.hpp"

namespace halfway {

/// Velocity (m/s) and spin (rad/s) of a node, global axes.
template <class T>
struct Twist {
  Vec3<T> v = Vec3<T>::Zero();
  Vec3<T> w = Vec3<T>::Zero();
};

/// Rate of RelativeMotion, in the axes of P_a and as seen from there: m/s and rad/s.
template <class T>
struct RelativeTwist {
  Vec3<T> p = Vec3<T>::Zero();    ///< p'
  Vec3<T> psi = Vec3<T>::Zero();  ///< left spin, R' = [psi] R
};

template <class T>
RelativeTwist<T> relative_twist(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a,
                                const Pose<T>& b, const Twist<T>& of_a, const Twist<T>& of_b) {
  const Mat3<T> to_a = (a.R * end_a.H).transpose();
  const Vec3<T> arm_a = a.R * end_a.o, arm_b = b.R * end_b.o;
  const Vec3<T> d = (b.x + arm_b) - (a.x + arm_a);
  const Vec3<T> d_rate = (of_b.v + of_b.w.cross(arm_b)) - (of_a.v + of_a.w.cross(arm_a));
  return {to_a * (d_rate - of_a.w.cross(d)), to_a * (of_b.w - of_a.w)};
}

/// Strain rates of a member of the family, and the loads of stresses conjugate to them.
template <class Translation, class Measure, class Transport>
struct StrainRate {
  [[no_unique_address]] Translation translation{};

  StrainRate() = default;
  /// Of a formulation that is a member of the family, with its xi.
  explicit StrainRate(const Family<Translation, Measure, Transport>& formulation)
      : translation(formulation.translation) {}

  /// e', m/s and rad/s: in the order of Family::strain.
  template <Kind kind, class T>
  Strain<T, kind> rate(const RelativeMotion<T>& m, const RelativeTwist<T>& twist) const {
    Strain<T, kind> out;
    if constexpr (kind != Kind::angular) {
      const auto by = strain_rates_of(m, translation.motion(T(m.theta.squaredNorm())));
      out.template head<3>() = by.J * twist.p + by.N * twist.psi;
    }
    if constexpr (kind != Kind::linear) out.template tail<3>() = Measure::rate(m) * twist.psi;
    return out;
  }

  /// The loads of a stress at the joint points, in the axes of P_a.
  template <Kind kind, class T>
  PointResponse<T> loads(const RelativeMotion<T>& m, const Strain<T, kind>& stress) const {
    PointResponse<T> r;
    r.f = r.m_b = Vec3<T>::Zero();
    if constexpr (kind != Kind::angular) {
      const auto by = strain_rates_of(m, translation.motion(T(m.theta.squaredNorm())));
      const Vec3<T> fbar = stress.template head<3>();
      r.f = by.J.transpose() * fbar;
      r.m_b = by.N.transpose() * fbar;
    }
    if constexpr (kind != Kind::linear) {
      const Vec3<T> mbar = stress.template tail<3>();
      if constexpr (Transport::kConjugate)
        r.m_b += Measure::rate(m).transpose() * mbar;
      else
        r.m_b += translation.rotation(m) * mbar;
    }
    r.m_a = -(r.m_b + m.p.cross(r.f));
    return r;
  }
};

template <class Translation, class Measure, class Transport>
StrainRate(const Family<Translation, Measure, Transport>&) -> StrainRate<Translation, Measure, Transport>;

/// Loads of a damper, to be added to those of the elastic joint: they balance what is applied to the nodes.
template <class T>
struct Damping {
  Eigen::Matrix<T, 12, 1> q;  ///< (f_a, m_a, f_b, m_b), global axes, N and N m, moments about the nodes
  T power;                    ///< what the loads take out of the motion, W: q . (v_a, w_a, v_b, w_b)
  T law_power;                ///< e' . C e', W
};

/// Kelvin-Voigt law: stress = C e'. The range of poses is that of the elastic formulation's strains.
/// @param C  N s/m, N m s/rad, symmetric, positive semi-definite for a damper
template <Kind kind, class T, class Translation, class Measure, class Transport>
Damping<T> damping(const StrainRate<Translation, Measure, Transport>& rates,
                   const Eigen::Matrix<T, strain_count(kind), strain_count(kind)>& C,
                   const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a, const Pose<T>& b,
                   const Twist<T>& of_a, const Twist<T>& of_b) {
  const RelativeMotion<T> m = full_motion(end_a, end_b, a, b);
  const Strain<T, kind> rate = rates.template rate<kind>(m, relative_twist(end_a, end_b, a, b, of_a, of_b));
  const Strain<T, kind> stress = C * rate;
  Damping<T> out;
  out.q = at_nodes<false>(rates.template loads<kind>(m, stress), m, end_a, end_b, a, b).q;
  out.power = out.q.template segment<3>(0).dot(of_a.v) + out.q.template segment<3>(3).dot(of_a.w) +
              out.q.template segment<3>(6).dot(of_b.v) + out.q.template segment<3>(9).dot(of_b.w);
  out.law_power = rate.dot(stress);
  return out;
}

}  // namespace halfway
