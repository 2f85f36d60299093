// Wrong twins of the joints: each is the healthy form with one mistake, on purpose.
//
// Projected<Parts> assembles [19, 30]; a mutant replaces one part of Healthy.
#pragma once

#include "reference/truth/closed_forms.hpp"

namespace halfway::verify::wrong {

namespace closed = reference::closed;
using closed::Geometry;
using closed::Loads;
using reference::JointSpec;

struct Healthy : closed::Intrinsic {
  template <class T>
  static Geometry<T> geometry(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    return closed::geometry(spec, a, b);
  }
  template <class T>
  static Vec3<T> strain_angle(const Geometry<T>& g) {
    return g.theta;
  }
  /// The frame that the loads, and not the strains, are turned with.
  template <class T>
  static Mat3<T> projection(const Geometry<T>&, const Mat3<T>& R) {
    return R;
  }
};

template <class Parts>
struct Projected {
  template <class T>
  static closed::Stress<T> stress(const JointSpec& spec, const Geometry<T>& g) {
    const Mat3<T> R = Parts::frame(g, T(spec.xi));
    return closed::stress<T>(spec, R.transpose() * g.d, Parts::strain_angle(g));
  }
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = Parts::geometry(spec, a, b);
    const T xi(spec.xi);
    const Mat3<T> R = Parts::projection(g, Parts::frame(g, xi));
    const closed::Stress<T> s = stress(spec, g);
    const Vec3<T> F = R * s.f, M = R * s.m;
    return closed::join<T>(-F, Parts::moment_a(g, xi, F) - M, F, Parts::moment_b(g, xi, F) + M);
  }
  /// Of the law: the potential of the forces, for the linear kind.
  template <class T>
  static T energy(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    return stress(spec, Parts::geometry(spec, a, b)).energy;
  }
};

struct TransposedFrame : Healthy {  // R^ = P_a exp(-xi theta)
  template <class T>
  static Mat3<T> frame(const Geometry<T>& g, const T& xi) {
    return g.P_a * closed::rotation<T>(xi * g.theta).transpose();
  }
};
struct XiForOneMinusXi : Healthy {  // in the frame
  template <class T>
  static Mat3<T> frame(const Geometry<T>& g, const T& xi) {
    return Healthy::frame<T>(g, T(1) - xi);
  }
};
struct XiForOneMinusXiInMoment : Healthy {  // in m_a [30b]
  template <class T>
  static Vec3<T> moment_a(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return -(g.arm_a.cross(F) + frame_spin(g, xi) * g.d.cross(F));
  }
};
struct SpinNotTransposed : Healthy {  // I^ for I^^T in m_b [30d]
  template <class T>
  static Vec3<T> moment_b(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return g.arm_b.cross(F) - frame_spin(g, xi) * g.d.cross(F);
  }
};
struct PrintedEq29 : Healthy {  // [d] missing, as [29] is printed: q = (d dbar / d pose)^T fbar
  template <class T>
  static Vec3<T> moment_a(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return -g.arm_a.cross(F) + frame_spin<T>(g, T(1) - xi) * F;
  }
  template <class T>
  static Vec3<T> moment_b(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return g.arm_b.cross(F) + frame_spin(g, xi).transpose() * F;
  }
};
struct HalfRate : Healthy {  // the half-way frame turning at (w_a + w_b)/2, as Drake's midpoint has it
  template <class T>
  static Vec3<T> moment_a(const Geometry<T>& g, const T&, const Vec3<T>& F) {
    return -(g.arm_a + g.d / T(2)).cross(F);
  }
  template <class T>
  static Vec3<T> moment_b(const Geometry<T>& g, const T&, const Vec3<T>& F) {
    return (g.arm_b - g.d / T(2)).cross(F);
  }
};
struct ProjectedWithNodeA : Healthy {  // MBDyn's invariant deformable joint
  template <class T>
  static Mat3<T> projection(const Geometry<T>& g, const Mat3<T>&) {
    return g.P_a;
  }
};
struct LogOfTranspose : Healthy {  // [36] as printed, theta = log(R^T)
  template <class T>
  static Vec3<T> strain_angle(const Geometry<T>& g) {
    return -g.theta;
  }
};
struct OffsetWithoutArm : Healthy {  // node b's force without its arm
  template <class T>
  static Vec3<T> moment_b(const Geometry<T>& g, const T& xi, const Vec3<T>& F) {
    return -frame_spin(g, xi).transpose() * g.d.cross(F);
  }
};
struct OffsetCarriedByNodeA : Healthy {  // o_b turned with R_a
  template <class T>
  static Geometry<T> geometry(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    Geometry<T> g = closed::geometry(spec, a, b);
    g.d -= g.arm_b;
    g.arm_b = a.R * spec.b.o.template cast<T>();
    g.d += g.arm_b;
    return g;
  }
};
struct NoArmMoment : Healthy {  // Chrono: equal and opposite at both joint points
  template <class T>
  static Vec3<T> moment_a(const Geometry<T>& g, const T&, const Vec3<T>& F) {
    return -g.arm_a.cross(F);
  }
  template <class T>
  static Vec3<T> moment_b(const Geometry<T>& g, const T&, const Vec3<T>& F) {
    return g.arm_b.cross(F);
  }
};

/// The conformal joint with sec^2(phi/N): 4 is right.
template <int N>
struct ConformalSecant {
  template <class T>
  static Vec3<T> nu(const Geometry<T>& g) {
    using std::tan, std::sin, std::cos;
    const T phi = g.theta.norm(), quarter = phi / T(4);
    return T(4) * sin(quarter) / cos(quarter) / phi * g.theta;
  }
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    using std::cos;
    const Geometry<T> g = closed::geometry(spec, a, b);
    const T c = cos(T(g.theta.norm() / T(N)));
    const Vec3<T> zero = Vec3<T>::Zero();
    const Vec3<T> M = Healthy::frame(g, T(0.5)) * closed::stress<T>(spec, zero, nu(g)).m / (c * c);
    return closed::join<T>(zero, -M, zero, M);
  }
  template <class T>
  static T energy(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    return closed::stress<T>(spec, Vec3<T>::Zero(), nu(closed::geometry(spec, a, b))).energy;
  }
};

/// Tangent of the angular joint [44]: M turns with node a and with the frame, K theta grows.
struct RightTangent {
  template <class T>
  static Mat3<T> geometric(const Vec3<T>& K_theta, const Vec3<T>& theta, const T& xi) {
    return xi * skew(K_theta) * closed::gamma<T>(xi * theta).transpose();
  }
  template <class T>
  static Mat3<T> rate(const Vec3<T>& theta) {
    return closed::gamma(theta).inverse();
  }
};
struct NoGeometricTerm : RightTangent {
  template <class T>
  static Mat3<T> geometric(const Vec3<T>&, const Vec3<T>&, const T&) {
    return Mat3<T>::Zero();
  }
};
struct GammaForInverse : RightTangent {
  template <class T>
  static Mat3<T> rate(const Vec3<T>& theta) {
    return closed::gamma(theta);
  }
};

template <class Parts>
struct AngularTangent : Projected<Healthy> {
  template <class T>
  static Eigen::Matrix<T, 12, 12> tangent(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = closed::geometry(spec, a, b);
    const reference::AnyLaw<T, 3> law(spec.law);
    const auto r = law(g.theta);
    const Mat3<T> R = Healthy::frame(g, T(spec.xi));
    const Vec3<T> M = R * r.stress;
    const Mat3<T> by_theta = R * (r.stiffness - Parts::geometric(r.stress, g.theta, T(spec.xi)));
    const Mat3<T> by_wb = by_theta * Parts::rate(g.theta) * g.P_a.transpose();
    const Mat3<T> by_wa = -by_wb - skew(M);
    Eigen::Matrix<T, 12, 12> out = Eigen::Matrix<T, 12, 12>::Zero();
    out.template block<3, 3>(3, 3) = -by_wa;
    out.template block<3, 3>(3, 9) = -by_wb;
    out.template block<3, 3>(9, 3) = by_wa;
    out.template block<3, 3>(9, 9) = by_wb;
    return out;
  }
};

}  // namespace halfway::verify::wrong
