// Other programs' joints from their sources and manuals (formulations/NOTATION.md), in global axes; see
// closed_forms.hpp.
#pragma once

#include "reference/truth/closed_forms.hpp"

namespace halfway::reference::closed {

/// Drake: torque N^T K q on b in the axes of a, q = (roll, pitch, yaw); half-way force at the midpoint.
struct DrakeRpy {
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    using std::atan2, std::cos, std::sin, std::sqrt;
    const Geometry<T> g = geometry(spec, a, b);
    const Mat3<T> R = g.P_a.transpose() * g.P_b;
    const T roll = atan2(R(2, 1), R(2, 2)), yaw = atan2(R(1, 0), R(0, 0));
    const T pitch = atan2(T(-R(2, 0)), T(sqrt(T(R(0, 0) * R(0, 0) + R(1, 0) * R(1, 0)))));
    const T cp = cos(pitch), sp = sin(pitch), cy = cos(yaw), sy = sin(yaw);
    Mat3<T> N;
    N << cy / cp, sy / cp, T(0), -sy, cy, T(0), cy * sp / cp, sy * sp / cp, T(1);
    const Mat3<T> half = Intrinsic::frame(g, T(0.5));
    const Stress<T> s = stress<T>(spec, half.transpose() * g.d, Vec3<T>(roll, pitch, yaw));
    const Vec3<T> F = half * s.f, M = g.P_a * (N.transpose() * s.m);
    const Vec3<T> reach_a = g.arm_a + g.d / T(2), reach_b = g.arm_b - g.d / T(2);  // to the midpoint
    return join<T>(-F, -reach_a.cross(F) - M, F, reach_b.cross(F) + M);
  }
};

/// Chrono: the motion of a seen from b, loads along b's axes with opposite sign at the two points.
struct ChronoBody {
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = geometry(spec, a, b);
    const Vec3<T> turn = rotation_vector<T>(g.P_b.transpose() * g.P_a);
    const Stress<T> s = stress<T>(spec, g.P_b.transpose() * -g.d, turn);
    const Vec3<T> F = g.P_b * s.f, M = g.P_b * s.m;
    return join<T>(F, g.arm_a.cross(F) + M, -F, -g.arm_b.cross(F) - M);
  }
};

/// Exudyn: (f, m) = A K (v, theta), A half-way, plus the couple (A (-v/2)) x f on both nodes.
struct ExudynIntrinsic {
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = geometry(spec, a, b);
    const Mat3<T> A = Intrinsic::frame(g, T(0.5));
    const Vec3<T> v = gamma(g.theta).inverse() * (g.P_a.transpose() * g.d);
    const Stress<T> s = stress<T>(spec, v, g.theta);
    const Vec3<T> F = A * s.f, M = A * s.m;
    const Vec3<T> couple = Vec3<T>(A * v / T(-2)).cross(F);
    return join<T>(-F, couple - M - g.arm_a.cross(F), F, couple + M + g.arm_b.cross(F));
  }
};

/// MBDyn's invariant deformable joint as coded: half-way strains, loads projected with P_a.
struct MbdynJointInv {
  template <class T>
  static Loads<T> loads(const JointSpec& spec, const Pose<T>& a, const Pose<T>& b) {
    const Geometry<T> g = geometry(spec, a, b);
    const Stress<T> s = stress<T>(spec, Intrinsic::frame(g, T(0.5)).transpose() * g.d, g.theta);
    const Vec3<T> F = g.P_a * s.f, M = g.P_a * s.m;
    return join<T>(-F, Intrinsic::moment_a(g, T(0.5), F) - M, F, Intrinsic::moment_b(g, T(0.5), F) + M);
  }
};

}  // namespace halfway::reference::closed
