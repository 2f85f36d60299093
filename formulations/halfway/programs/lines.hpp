// Bonds of particles: springs along and across the line between two points. Axis z is the bond at rest, of
// length kRest; K_f = diag(ks, ks, kr), K_m = diag(kb, kb, kt).
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

inline constexpr double kBondRest = 1;  ///< m

namespace detail {

/// Angle from u to v, 0 ... pi, of unit vectors.
template <class T>
T angle_between(const Vec3<T>& u, const Vec3<T>& v) {
  using std::atan2, std::sqrt;
  return atan2(T(sqrt(u.cross(v).squaredNorm())), T(u.dot(v)));
}

template <class T>
T length(const Vec3<T>& v) {
  using std::sqrt;
  return sqrt(v.squaredNorm());
}

/// Stretch along h and shear across it of the line rc seen in a frame: kr (r - r0) h + ks r gamma t x h.
template <class T>
Vec3<T> line_force(const Vec3<T>& rc, const Mat3<T>& K_f) {
  const T r = length(rc);
  const Vec3<T> h = rc / r, z = Vec3<T>::Unit(2);
  const T gamma = angle_between<T>(z, h);
  const Vec3<T> t = unit<T>(z.cross(rc));
  return K_f(2, 2) * T(r - T(kBondRest)) * h + K_f(0, 0) * r * gamma * t.cross(h);
}

}  // namespace detail

/// Since 2026: seen in the half-way frame, so that the order of the particles does not matter. Balanced, and
/// still not conservative.
struct LammpsBpm {
  static constexpr const char* name = "lammps_bpm";
  static constexpr const char* stands_for = "LAMMPS bpm/rotational, frame average";
  static constexpr ProgramFacts facts{.known = Known::read_in_source,
                                      .source = "LAMMPS, comphy-lab ace00b9",
                                      .order_free = true,
                                      .is_bond = true};

  template <class T>
  static ProgramLoads<T> at_points(const RelativeMotion<T>& m, const Mat3<T>& K_f, const Mat3<T>& K_m) {
    using std::atan2;
    const so3::Quaternion<T> half = so3::half(m.q);
    const Mat3<T> C = so3::matrix(half);
    const Vec3<T> rc = C.transpose() * m.p;
    const Vec3<T> f = C * detail::line_force<T>(rc, K_f);
    const Vec3<T> h = unit<T>(rc);
    const T twist = T(2) * atan2(T(half.v.dot(h)), half.w);
    const Mat3<T> twisted = so3::exp<T>(twist * h);
    const Mat3<T> S = twisted.transpose() * C;  // what the half turn swings
    const Mat3<T> both = S * twisted * S * twisted.transpose();
    return AtMiddle::loads<T>(m.p, f, moment(both, C, h, twist, K_m));
  }

 private:
  template <class T>
  static Vec3<T> moment(const Mat3<T>& swung, const Mat3<T>& C, const Vec3<T>& h, const T& twist,
                        const Mat3<T>& K_m) {
    const Vec3<T> swing = so3::log<T>(swung);
    return C * Vec3<T>(K_m(0, 0) * swing + T(2) * K_m(2, 2) * twist * h);
  }
};

/// Before: seen in the frame of one particle. The moment and the force depend on which. Our rewriting of the
/// code; the part of the shear that the swing makes is checked to first order alone.
struct LammpsBpmOld {
  static constexpr const char* name = "lammps_bpm_particle";
  static constexpr const char* stands_for = "LAMMPS bpm/rotational, frame particle (before 2026)";
  static constexpr ProgramFacts facts{
      .known = Known::reconstructed, .source = "LAMMPS 07ac930 (Wang and Mora)", .is_bond = true};

  template <class T>
  static ProgramLoads<T> at_points(const RelativeMotion<T>& m, const Mat3<T>& K_f, const Mat3<T>& K_m) {
    using std::atan2;
    const T r = detail::length(m.p);
    const Vec3<T> h = m.p / r, turned = m.R * h;
    const T swing = detail::angle_between<T>(h, turned);
    const T twist = T(2) * atan2(T(m.q.v.dot(h)), m.q.w);
    const Vec3<T> k = unit<T>(h.cross(turned));
    const Vec3<T> f = detail::line_force<T>(m.p, K_f) - K_f(0, 0) * r * T(swing / T(2)) * k.cross(h);
    return AtMiddle::loads<T>(m.p, f, Vec3<T>(K_m(0, 0) * swing * k + K_m(2, 2) * twist * h));
  }
};

/// Bending and torsion of the whole rotation vector, split along the line of centres; shear is a path's and
/// zero here.
struct YadeLine {
  static constexpr const char* name = "yade_line";
  static constexpr const char* stands_for = "Yade ScGeom6D cohesive contact, without shear";
  static constexpr ProgramFacts facts{.source = "Yade 2023.02a, 3e-14", .order_free = true, .is_bond = true};

  template <class T>
  static ProgramLoads<T> at_points(const RelativeMotion<T>& m, const Mat3<T>& K_f, const Mat3<T>& K_m) {
    const T r = detail::length(m.p);
    const Vec3<T> n = m.p / r;
    const Vec3<T> f = K_f(2, 2) * T(r - T(kBondRest)) * n;
    const T k_bend = K_m(0, 0), along = T(K_m(2, 2) - k_bend) * n.dot(m.theta);
    return AtMiddle::loads<T>(m.p, f, Vec3<T>(k_bend * m.theta + along * n));
  }
};

}  // namespace halfway::programs
