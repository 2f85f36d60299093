// What a program's joint sees, and what it answers.
//
// The laws of this folder are other programs' own, for comparison: loads alone, by a linear spring along the
// joint axes. A program joint is a type with `name`, `stands_for`, `facts` (ProgramFacts) and one of
//   at_points(RelativeMotion, K_f, K_m)   loads at the joint points, axes of P_a
//   at_nodes(Situation)                   for what a relative motion does not tell: global axes, masses
// Signs as everywhere: internal loads, on b those conjugate to the stretch.
#pragma once

#include "halfway/joint/pose.hpp"

namespace halfway::programs {

/// How a law is known.
enum class Known {
  measured,        ///< the program was run: version and error in `source`
  read_in_source,  ///< its code was read, not run
  manual,          ///< its manual says so
  reconstructed    ///< our reading of an incomplete text
};

constexpr const char* to_string(Known known) {
  constexpr const char* kNames[] = {"measured", "read in the source", "manual", "reconstructed"};
  return kNames[int(known)];
}

/// What a law is known to do; verify holds each word to it.
struct ProgramFacts {
  Known known = Known::measured;
  const char* source = "";              ///< program, version, document
  bool balanced = true;                 ///< moments about one point add to zero
  bool order_free = false;              ///< the same loads when the bodies are exchanged
  bool objective = true;                ///< a rigid turn of both bodies turns the loads and does nothing else
  bool isotropic_conservative = false;  ///< no work round a loop of rotations, K_m = k I
  bool anisotropic_conservative = false;  ///< nor with three stiffnesses
  bool tensorial = false;                 ///< e(Q R Q^T) = Q e(R), K_m = I
  bool isotropic_moments = false;         ///< the program takes one stiffness for the three rotations
  bool isotropic_forces = false;          ///< and one for the three translations
  bool asks_for_masses = false;           ///< the loads depend on the bodies' masses: no force law
  bool is_bond = false;                   ///< the joint points rest apart along z (lines.hpp), else together
  bool has_forces = true;                 ///< its springs of translation are known, too
};

/// Two bodies, the joint's ends on them, and the springs along the joint axes, N/m and N m/rad.
template <class T>
struct Situation {
  Pose<T> a, b;
  JointEnd<T> end_a, end_b;
  Mat3<T> K_f, K_m;
  T mass_a{1}, mass_b{1};        ///< kg, for laws that ask for it
  T inertia_a{1}, inertia_b{1};  ///< kg m2, of balls
};

/// Force on b (that on a is its opposite) and moments about the two joint points, axes of P_a.
template <class T>
struct ProgramLoads {
  Vec3<T> f, m_a, m_b;
};

/// f_a, m_a, f_b, m_b about the nodes, global axes.
template <class T>
using TwelveLoads = Eigen::Matrix<T, 12, 1>;

template <class T>
Mat3<T> frame_a(const Situation<T>& s) {
  return s.a.R * s.end_a.H;
}
template <class T>
Mat3<T> frame_b(const Situation<T>& s) {
  return s.b.R * s.end_b.H;
}
/// From joint point a to joint point b, global axes.
template <class T>
Vec3<T> reach(const Situation<T>& s) {
  const Vec3<T> arm_a = s.a.R * s.end_a.o, arm_b = s.b.R * s.end_b.o;
  return (s.b.x + arm_b) - (s.a.x + arm_a);
}

/// The force f on b at its joint point and -f on a at its own, and the two moments, carried to the nodes.
template <class T>
TwelveLoads<T> carried(const Situation<T>& s, const Vec3<T>& f, const Vec3<T>& m_a, const Vec3<T>& m_b) {
  const Vec3<T> arm_a = s.a.R * s.end_a.o, arm_b = s.b.R * s.end_b.o;
  TwelveLoads<T> q;
  q << Vec3<T>(-f), Vec3<T>(m_a - arm_a.cross(f)), f, Vec3<T>(m_b + arm_b.cross(f));
  return q;
}

/// What the law answers, about the nodes, global axes.
template <class Law, class T>
TwelveLoads<T> loads(const Situation<T>& s) {
  if constexpr (requires { Law::at_nodes(s); }) {
    return Law::at_nodes(s);
  } else {
    const Mat3<T> P_a = frame_a(s);
    const Mat3<T> R_ab = P_a.transpose() * frame_b(s);
    const Vec3<T> p = P_a.transpose() * reach(s);
    const ProgramLoads<T> at = Law::at_points(relative_motion<T>(R_ab, p), s.K_f, s.K_m);
    return carried<T>(s, P_a * at.f, P_a * at.m_a, P_a * at.m_b);
  }
}

}  // namespace halfway::programs
