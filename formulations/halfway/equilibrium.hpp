// Equilibrium of one loaded node on a joint whose other node is clamped: Newton in the joint's own
// coordinates with the analytic tangent, adaptive load steps, and an estimate of the answer's own error.
//
//   Outcome<double> state;                                 // unloaded, unstrained
//   state = follow(joint, a, load, state, 1.0);            // the whole load
//   if (state.status == Status::converged) use(node_b(joint.a, joint.b, a, state.joint), state.error);
#pragma once

#include "halfway/equilibrium/follow.hpp"
#include "halfway/joint.hpp"

#include <type_traits>

namespace halfway {

/// The joint's load on b, from a joint's own pose. The joint must outlive it: no temporary.
/// @param on_a  for a loaded node a: what it carries, as a load on b
template <Kind kind, class T, class F, class L>
auto internal_of(const Joint<kind, T, F, L>& joint, bool on_a = false) {
  return [&joint, on_a](const Pose<T>& pose) {
    constexpr int n = unknown_count(kind);
    Balance<T, n> out;
    const RelativeMotion<T> m = relative_motion<T>(pose.R, pose.x);
    if constexpr (kind == Kind::angular) {
      const AngularResponse<T> r = joint.formulation.template angular<true>(m, joint.law);
      out = {r.m, r.m_psi};
    } else {
      const PointResponse<T> r = joint.formulation.template point<kind, true>(m, joint.law);
      out.load.template head<3>() = r.f;
      out.tangent.template topLeftCorner<3, 3>() = r.f_p;
      if constexpr (kind == Kind::linear_angular) {
        const T sign(on_a ? -1 : 1);
        out.load.template tail<3>() = sign * (on_a ? r.m_a : r.m_b);
        out.tangent.template topRightCorner<3, 3>() = r.f_psi;
        out.tangent.template bottomLeftCorner<3, 3>() = sign * (on_a ? r.m_a_p : r.m_b_p);
        out.tangent.template bottomRightCorner<3, 3>() = sign * (on_a ? r.m_a_psi : r.m_b_psi);
      }
    }
    return out;
  };
}
template <Kind kind, class T, class F, class L>
void internal_of(const Joint<kind, T, F, L>&&, bool = false) = delete;

/// On from an equilibrium to another load factor. Node a is clamped at `a`, the load acts on node b.
template <Kind kind, class T, class F, class L>
Outcome<T> follow(const Joint<kind, T, F, L>& joint, const Pose<T>& a, const NodeLoad<T>& load,
                  const Outcome<T>& from, const std::type_identity_t<T>& factor_to,
                  const SolverOptions<T>& options = {}) {
  const auto internal = internal_of(joint);
  const JointLoad<T> at_joint = joint_load<T>(kind, load, a.R * joint.a.H, joint.b);
  return PathFollower<kind, T, decltype(internal)>(internal, at_joint, options, from).to(factor_to);
}

/// The pose of node b for node a at `a` and the joint's pose.
template <class T>
Pose<T> node_b(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a, const Pose<T>& joint) {
  const Mat3<T> P_a = a.R * end_a.H;
  Pose<T> b;
  b.R = P_a * joint.R * end_b.H.transpose();
  b.x = a.x + a.R * end_a.o + P_a * joint.x - b.R * end_b.o;
  return b;
}

/// The pose of node a for node b at `b`.
template <class T>
Pose<T> node_a(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& b, const Pose<T>& joint) {
  const Mat3<T> P_a = b.R * end_b.H * joint.R.transpose();
  Pose<T> a;
  a.R = P_a * end_a.H.transpose();
  a.x = b.x + b.R * end_b.o - P_a * joint.x - a.R * end_a.o;
  return a;
}

/// The unstrained pose of node b for node a at `a`.
template <class T>
Pose<T> unstrained(const JointEnd<T>& end_a, const JointEnd<T>& end_b, const Pose<T>& a) {
  return node_b(end_a, end_b, a, Pose<T>{});
}

}  // namespace halfway
