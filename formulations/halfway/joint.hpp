// A joint between two nodes: loads on the nodes, and their tangent, from poses.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

/// A formulation, a law and two ends. Kinds cost what they are: an angular joint computes nothing
/// linear and has 3x3 tangent blocks.
template <Kind kind, class T, class Formulation, class LawT>
struct Joint {
  static_assert(
      Law<LawT, T, strain_count(kind)>,
      "the law of a joint takes 3 strains (angular, linear) or 6 (linear_angular) in the joint's scalar, "
      "and returns LawResponse<T, N>{stress, stiffness}");
  Formulation formulation{};
  LawT law;
  JointEnd<T> a{};
  JointEnd<T> b{};
};

/// Moment on node b, global axes, N m (node a has the opposite), and its derivatives by the spins. Internal
/// loads, as NodeLoads.
template <class T>
struct AngularLoads {
  Vec3<T> m_b;
  Mat3<T> m_b_wa, m_b_wb;
};

/// Loads (f_a, m_a, f_b, m_b), global axes, moments about the nodes; and their derivative by
/// (dx_a, w_a, dx_b, w_b), spins in global axes. Signs: q = dU/dx, internal loads: what has to be applied to
/// the nodes to hold them there. Add -q to your equations of motion.
template <class T>
struct NodeLoads {
  Eigen::Matrix<T, 12, 1> q;
  Eigen::Matrix<T, 12, 12> tangent;
};

template <class T>
RelativeMotion<T> angular_motion(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a,
                                 const Pose<T>& b) {
  const Mat3<T> R_ab = (a.R * end_a.H).transpose() * (b.R * end_b.H);
  return relative_motion<T>(R_ab, Vec3<T>::Zero());
}

/// p alone, for joints that no rotation concerns.
template <class T>
RelativeMotion<T> linear_motion(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a,
                                const Pose<T>& b) {
  RelativeMotion<T> m;
  m.p = (a.R * end_a.H).transpose() * ((b.x + b.R * end_b.o) - (a.x + a.R * end_a.o));
  return m;
}

template <class T>
RelativeMotion<T> full_motion(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a,
                              const Pose<T>& b) {
  const Mat3<T> P_a = a.R * end_a.H;
  const Vec3<T> d = (b.x + b.R * end_b.o) - (a.x + a.R * end_a.o);
  const Mat3<T> R_ab = P_a.transpose() * (b.R * end_b.H);
  return relative_motion<T>(R_ab, P_a.transpose() * d);
}

/// What of the relative motion the joint needs, and no more.
template <Kind kind, class T, class F, class L>
RelativeMotion<T> motion_of(const Joint<kind, T, F, L>& joint, const Pose<T>& a, const Pose<T>& b) {
  if constexpr (kind == Kind::angular) {
    return angular_motion(joint.a, joint.b, a, b);
  } else if constexpr (kind == Kind::linear && F::kLinearWithoutRotation) {
    return linear_motion(joint.a, joint.b, a, b);
  } else {
    return full_motion(joint.a, joint.b, a, b);
  }
}

/// The strains that the law sees. @param a, b  poses of the nodes.
template <Kind kind, class T, class F, class L>
Strain<T, kind> strain(const Joint<kind, T, F, L>& joint, const Pose<T>& a, const Pose<T>& b) {
  return joint.formulation.template strain<kind>(motion_of(joint, a, b));
}

/// The potential, J, where the formulation has one: the law's energy at the strain, unless it brings its own.
template <Kind kind, class T, class F, class L>
T energy(const Joint<kind, T, F, L>& joint, const Pose<T>& a, const Pose<T>& b) {
  const RelativeMotion<T> m = motion_of(joint, a, b);
  if constexpr (requires { joint.formulation.template energy<kind>(m, joint.law); })
    return joint.formulation.template energy<kind>(m, joint.law);
  else
    return joint.law.energy(joint.formulation.template strain<kind>(m));
}

/// Loads of an angular joint; the tangent blocks are filled only on request.
template <bool with_tangent, class T, class F, class L>
AngularLoads<T> loads(const Joint<Kind::angular, T, F, L>& joint, const Pose<T>& a, const Pose<T>& b) {
  const RelativeMotion<T> m = motion_of(joint, a, b);
  const AngularResponse<T> r = joint.formulation.template angular<with_tangent>(m, joint.law);
  const Mat3<T> P_a = a.R * joint.a.H;
  AngularLoads<T> out;
  out.m_b = P_a * r.m;
  if constexpr (with_tangent) {
    out.m_b_wb = P_a * r.m_psi * P_a.transpose();
    out.m_b_wa = -out.m_b_wb - skew(out.m_b);  // P_a turns with node a
  }
  return out;
}

/// Carries the loads at the joint points, in the axes of P_a, to the nodes in global axes [30].
template <bool with_tangent, class T>
NodeLoads<T> at_nodes(const PointResponse<T>& r, const RelativeMotion<T>& m, const JointEnd<T>& end_a,
                      const JointEnd<T>& end_b, const Pose<T>& a, const Pose<T>& b) {
  const Mat3<T> P_a = a.R * end_a.H;
  const Vec3<T> arm_a = a.R * end_a.o;
  const Vec3<T> arm_b = b.R * end_b.o;
  const Vec3<T> f = P_a * r.f, m_a = P_a * r.m_a, m_b = P_a * r.m_b;
  NodeLoads<T> out;
  out.q << -f, m_a - arm_a.cross(f), f, m_b + arm_b.cross(f);
  if constexpr (with_tangent) {
    // (p, psi) in global axes by (dx_a, w_a, dx_b, w_b): dp = dx_b - [arm_b] w_b - dx_a +
    // [arm_a + d] w_a [29, with the frame of node a], psi = w_b - w_a.
    const Mat3<T> reach_a = skew<T>(arm_a + P_a * m.p), reach_b = skew(arm_b), lever_a = skew(arm_a);
    const auto turned = [&](const Mat3<T>& block) -> Mat3<T> { return P_a * block * P_a.transpose(); };
    const auto set = [&](int i, int j, const Mat3<T>& block) {
      out.tangent.template block<3, 3>(3 * i, 3 * j) = block;
    };
    struct Row {
      Mat3<T> xa, wa, xb, wb;
    };
    // The components of v are in P_a, which turns with node a: -[v] w_a.
    const auto row = [&](const Vec3<T>& v, const Mat3<T>& v_p, const Mat3<T>& v_psi) -> Row {
      const Mat3<T> by_p = turned(v_p), by_psi = turned(v_psi);
      return {-by_p, by_p * reach_a - by_psi - skew(v), by_p, by_psi - by_p * reach_b};
    };
    const Row d_f = row(f, r.f_p, r.f_psi);
    const Row d_a = row(m_a, r.m_a_p, r.m_a_psi);
    const Row d_b = row(m_b, r.m_b_p, r.m_b_psi);
    set(0, 0, -d_f.xa), set(0, 1, -d_f.wa), set(0, 2, -d_f.xb), set(0, 3, -d_f.wb);
    set(2, 0, d_f.xa), set(2, 1, d_f.wa), set(2, 2, d_f.xb), set(2, 3, d_f.wb);
    // The arms turn with their own nodes: d(arm) x f = [f][arm] w.
    set(1, 0, d_a.xa - lever_a * d_f.xa), set(1, 1, d_a.wa - lever_a * d_f.wa - skew(f) * lever_a);
    set(1, 2, d_a.xb - lever_a * d_f.xb), set(1, 3, d_a.wb - lever_a * d_f.wb);
    set(3, 0, d_b.xa + reach_b * d_f.xa), set(3, 1, d_b.wa + reach_b * d_f.wa);
    set(3, 2, d_b.xb + reach_b * d_f.xb), set(3, 3, d_b.wb + reach_b * d_f.wb + skew(f) * reach_b);
  }
  return out;
}

/// Loads of a linear or linear/angular joint; the tangent is filled only on request.
template <bool with_tangent, Kind kind, class T, class F, class L>
requires(kind != Kind::angular) NodeLoads<T> loads(const Joint<kind, T, F, L>& joint, const Pose<T>& a,
                                                   const Pose<T>& b) {
  const RelativeMotion<T> m = motion_of(joint, a, b);
  const PointResponse<T> r = joint.formulation.template point<kind, with_tangent>(m, joint.law);
  return at_nodes<with_tangent>(r, m, joint.a, joint.b, a, b);
}

// What is wrong with a call, in one sentence.

template <Kind kind, class T, class F, class L>
void loads(const Joint<kind, T, F, L>&, const Pose<T>&, const Pose<T>&) {
  static_assert(kind != kind,
                "say loads<true>(joint, a, b) for loads and tangent, loads<false> for loads alone");
}

template <bool with_tangent, Kind kind, class T, class F, class L, class A, class B>
requires(!std::same_as<A, T> || !std::same_as<B, T>) void loads(const Joint<kind, T, F, L>&, const Pose<A>&,
                                                                const Pose<B>&) {
  static_assert(kind != kind, "joint and poses have one scalar: a joint in float takes poses in float");
}

}  // namespace halfway
