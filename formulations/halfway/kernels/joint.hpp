// A joint between two nodes by its kernel: loads and tangent from positions and unit quaternions.
//
// The fast twin of halfway/joint.hpp: same loads, same signs, another text. With g++ compile with
// -O3 -fno-tree-slp-vectorize: its packing of a single joint's numbers costs up to a factor of two.
#pragma once

#include "halfway/kernels/kernel.hpp"

namespace halfway::kernel {

/// Position (m, global axes) and orientation (node axes -> global axes) of a node.
template <class T>
struct NodePose {
  V3<T> x;
  Quat<T> q;
};

/// Joint point o (m) and joint frame h of one end, constant in the node's axes [8].
template <class T>
struct KernelEnd {
  V3<T> o;
  Quat<T> h;
};

/// Joint points and frames at the nodes themselves: nothing to carry, nothing to pay.
struct NoEnds {};

template <class T>
struct Ends {
  KernelEnd<T> a, b;
};

/// @tparam K  a kernel, from KernelOf<Formulation>::make; L: a law of laws.hpp; E: NoEnds or Ends.
template <Kind kind, class K, class L, class E = NoEnds>
struct KernelJoint {
  K kernel;
  L law;
  [[no_unique_address]] E ends{};
};

/// How the angle is taken (functions.hpp) and how the relative quaternion (motion.hpp).
template <class A = ExactAngle, class D = Uncompensated>
struct Accuracy {
  using Angle = A;
  using Differences = D;
};

/// What of the relative rotation a kernel asks for: all, or frame a alone.
template <class K, Kind kind, class Differences = Uncompensated, class T>
HALFWAY_INLINE Relative<T> relative_for(const Quat<T>& a, const Quat<T>& b) {
  if constexpr (requires { requires !K::template kNeedsRelative<kind>; })
    return frame_a_alone(a);
  else
    return relative<Differences>(a, b);
}

template <class K, Kind kind, class Differences, class T>
HALFWAY_INLINE Relative<T> relative_of(const NoEnds&, const Quat<T>& a, const Quat<T>& b) {
  return relative_for<K, kind, Differences>(a, b);
}
template <class K, Kind kind, class Differences, class T, class C>
HALFWAY_INLINE Relative<T> relative_of(const Ends<C>& ends, const Quat<T>& a, const Quat<T>& b) {
  const auto joint_frame = [](const Quat<T>& q, const Quat<C>& h) {
    return q * Quat<T>{T(h.w), {T(h.v.x), T(h.v.y), T(h.v.z)}};
  };
  if constexpr (requires { requires !K::template kNeedsRelative<kind>; })
    return frame_a_alone(joint_frame(a, ends.a.h));
  else
    return relative<Differences>(joint_frame(a, ends.a.h), joint_frame(b, ends.b.h));
}

/// Moment on b, N m, and its derivatives by the spins; nothing linear is read or computed.
template <bool with_tangent, class Accuracy = Accuracy<>, class T, class K, class L, class E>
HALFWAY_INLINE MomentLoads<T> loads(const KernelJoint<Kind::angular, K, L, E>& joint, const Quat<T>& a,
                                    const Quat<T>& b) {
  const Relative<T> r = relative_of<K, Kind::angular, typename Accuracy::Differences>(joint.ends, a, b);
  return joint.kernel.template angular<typename Accuracy::Angle, with_tangent>(r, joint.law);
}

/// Is the force's derivative by the position symmetric, and are the loads balanced?
template <class K>
inline constexpr bool kSymmetricForce = requires {
  requires K::kSymmetricForce;
};
/// Do the loads follow from a potential, whatever the law (its stiffness is symmetric)?
template <class K, Kind kind>
inline constexpr bool kConservative = requires {
  requires K::template kConservative<kind>;
};

/// Loads about the nodes, with joint points at them.
/// @param D  from node a to b, global axes, m
/// @param out  PointLoads, or what takes its parts one after the other
template <class Angle, Kind kind, bool with_tangent, class K, class L, class T, class Out>
HALFWAY_INLINE void put_node_loads(const K& kernel, const L& law, const Relative<T>& r, const V3<T>& D,
                                   Out& out) {
  if constexpr (requires { kernel.template at_nodes<Angle, kind, with_tangent>(r, D, law, out); }) {
    kernel.template at_nodes<Angle, kind, with_tangent>(r, D, law, out);
  } else {
    auto p = kernel.template point<Angle, kind, with_tangent>(r, D, law);
    complete<K::kBalanced, kConservative<K, kind>, with_tangent>(D, p);
    assign<with_tangent>(p, out);
  }
}
template <class Angle, Kind kind, bool with_tangent, class K, class L, class T>
HALFWAY_INLINE PointLoads<T> node_loads(const K& kernel, const L& law, const Relative<T>& r, const V3<T>& D) {
  PointLoads<T> out;
  put_node_loads<Angle, kind, with_tangent>(kernel, law, r, D, out);
  return out;
}
/// The same with joint points at r_a and r_b from the nodes, global axes, m.
template <class Angle, Kind kind, bool with_tangent, class K, class L, class T>
HALFWAY_INLINE PointLoads<T> node_loads(const K& kernel, const L& law, const Relative<T>& r, const V3<T>& D,
                                        const V3<T>& r_a, const V3<T>& r_b) {
  auto p = kernel.template point<Angle, kind, with_tangent>(r, (D + r_b) - r_a, law);
  carry<K::kBalanced, with_tangent>(r_a, r_b, p);
  complete<K::kBalanced, kConservative<K, kind>, with_tangent>(D, p);
  return p;
}

/// Force on b, moments about both nodes, global axes, and their derivatives.
template <bool with_tangent, class Accuracy = Accuracy<>, Kind kind, class T, class K, class L, class E>
HALFWAY_INLINE PointLoads<T> loads(const KernelJoint<kind, K, L, E>& joint, const NodePose<T>& a,
                                   const NodePose<T>& b) {
  static_assert(kind != Kind::angular, "an angular joint takes orientations alone");
  const Relative<T> r = relative_of<K, kind, typename Accuracy::Differences>(joint.ends, a.q, b.q);
  using Angle = typename Accuracy::Angle;
  const V3<T> D = b.x - a.x;
  if constexpr (std::is_same_v<E, NoEnds>) {
    return node_loads<Angle, kind, with_tangent>(joint.kernel, joint.law, r, D);
  } else {
    const auto arm = [](const auto& end, const Quat<T>& q) {
      return matrix(q) * V3<T>{T(end.o.x), T(end.o.y), T(end.o.z)};
    };
    return node_loads<Angle, kind, with_tangent>(joint.kernel, joint.law, r, D, arm(joint.ends.a, a.q),
                                                 arm(joint.ends.b, b.q));
  }
}

}  // namespace halfway::kernel
