// Jolt SixDOFConstraint with motors on one or two of the three rotations: it takes the part of the
// quaternion.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// A stiffness of zero in K_m is a motor that is off. One axis off: the rotation without its twist about it;
/// two off: the twist about the one left. No axis off is `jolt_6dof`.
struct JoltPartial {
  static constexpr const char* name = "jolt_partial";
  static constexpr const char* stands_for = "Jolt SixDOFConstraint, some rotations free";
  static constexpr ProgramFacts facts{
      .source = "Jolt (npm jolt-physics 1.1.0), 3e-6", .isotropic_conservative = true, .tensorial = true};

  template <class T>
  static ProgramLoads<T> at_points(const RelativeMotion<T>& m, const Mat3<T>& K_f, const Mat3<T>& K_m) {
    const Vec3<T> f = K_f * m.p;
    const Vec3<T> stress = K_m * Vec3<T>(T(2) * seen(m.q, K_m));
    return AtB::loads<T>(m.p, f, m.R * stress);
  }

 private:
  /// The vector part of what the motors see of q, on the shorter way round.
  template <class T>
  static Vec3<T> seen(const so3::Quaternion<T>& q, const Mat3<T>& K_m) {
    int off = 0, axis_off = 0, axis_on = 0;
    for (int i = 0; i < 3; ++i) {
      const bool is_off = K_m(i, i) == T(0);
      off += is_off;
      (is_off ? axis_off : axis_on) = i;
    }
    if (off == 0) return q.v;
    if (off == 1) return without_twist(q, axis_off);
    return Vec3<T>::Unit(axis_on) * twist(q, axis_on).v[axis_on];
  }

  template <class T>
  static so3::Quaternion<T> twist(const so3::Quaternion<T>& q, int axis) {
    using std::sqrt;
    const T length = sqrt(T(q.w * q.w + q.v[axis] * q.v[axis]));
    return {q.w / length, Vec3<T>(Vec3<T>::Unit(axis) * T(q.v[axis] / length))};
  }

  /// vec(t* q), t the twist about the axis: w of t* q is not negative.
  template <class T>
  static Vec3<T> without_twist(const so3::Quaternion<T>& q, int axis) {
    const so3::Quaternion<T> t = twist(q, axis);
    return t.w * q.v - q.w * t.v - t.v.cross(q.v);
  }
};

}  // namespace halfway::programs
