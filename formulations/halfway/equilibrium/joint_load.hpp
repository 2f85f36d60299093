// Loads on a node as its joint point feels them: there no lever of the node enters a stiff direction.
#pragma once

#include "halfway/joint/pose.hpp"

#include <cmath>

namespace halfway {

/// Load on the loaded node at load factor 1; the solver scales it. Forces at several points are several of
/// these.
template <class T>
struct NodeLoad {
  Vec3<T> force = Vec3<T>::Zero();            ///< fixed direction, global axes, N
  Vec3<T> point = Vec3<T>::Zero();            ///< where it acts, axes of the node, m
  Vec3<T> moment = Vec3<T>::Zero();           ///< fixed direction, global axes, N m
  Vec3<T> follower_moment = Vec3<T>::Zero();  ///< turns with the node, axes of the node, N m
  Vec3<T> follower_force = Vec3<T>::Zero();   ///< likewise, at `point`, N
  /// Four dead forces on a cross that is fixed to the node and across the moment while nothing is strained;
  /// conservative. Global axes, N m. Once the node has turned by theta about it, cos(theta) of it is left.
  Vec3<T> semi_tangential_moment = Vec3<T>::Zero();
  /// One pair of dead forces on an arm that is fixed to the node, across the moment while nothing is
  /// strained; conservative. Global axes, N m.
  Vec3<T> quasi_tangential_moment = Vec3<T>::Zero();
  Vec3<T> arm = Vec3<T>::UnitX();  ///< of that pair, axes of the node; its length means nothing
};

/// What is unknown of the loaded node: 3 rotations, 3 displacements (the orientation is held), or all 6.
constexpr int unknown_count(Kind kind) { return strain_count(kind); }

/// Such loads, about the joint point of the loaded node. They add up by +=.
template <class T>
struct JointLoad {
  bool on_a = false;                          ///< node a is the loaded one, node b is clamped
  Vec3<T> force = Vec3<T>::Zero();            ///< axes of the clamped joint frame
  Vec3<T> moment = Vec3<T>::Zero();           ///< likewise
  Vec3<T> follower_moment = Vec3<T>::Zero();  ///< axes of the loaded frame
  Vec3<T> follower_force = Vec3<T>::Zero();   ///< likewise, at the joint point
  /// Sum of f r^T, f in axes of the clamped joint frame, r from the joint point to the force in those of the
  /// loaded one, N m: all that dead forces at several points need, for their moment changes as the node
  /// turns.
  Mat3<T> virial = Mat3<T>::Zero();
  T virial_size{0};  ///< sum of |f| |r|
  T reach{0};        ///< m: how far node and forces are from the joint point

  JointLoad& operator+=(const JointLoad& other) { return add(other, T(1)); }
  JointLoad& add(const JointLoad& other, const T& times) {
    using std::abs;
    force += times * other.force;
    moment += times * other.moment;
    follower_moment += times * other.follower_moment;
    follower_force += times * other.follower_force;
    virial += times * other.virial;
    virial_size += T(abs(times)) * other.virial_size;
    if (other.reach > reach) reach = other.reach;
    return *this;
  }
};

/// @param clamped_frame  joint frame of the clamped node, to global axes
template <class T>
JointLoad<T> joint_load(Kind kind, const NodeLoad<T>& load, const Mat3<T>& clamped_frame,
                        const JointEnd<T>& loaded, bool on_a = false) {
  JointLoad<T> out;
  out.on_a = on_a;
  out.force = clamped_frame.transpose() * load.force;
  out.moment = clamped_frame.transpose() * load.moment;
  out.follower_moment = loaded.H.transpose() * load.follower_moment;
  // An angular joint carries a couple; its force is carried where the node is held, at its origin.
  const Vec3<T> arm = kind == Kind::angular ? load.point : Vec3<T>(load.point - loaded.o);
  const Vec3<T> r = loaded.H.transpose() * arm;
  out.virial = out.force * r.transpose();
  out.virial_size = out.force.norm() * arm.norm();
  out.follower_force = loaded.H.transpose() * load.follower_force;
  out.follower_moment += r.cross(out.follower_force);
  // A cross in any axes across the moment: half of [m], the same from both frames while nothing is strained.
  const Vec3<T> semi = clamped_frame.transpose() * load.semi_tangential_moment;
  const Vec3<T> quasi = clamped_frame.transpose() * load.quasi_tangential_moment;
  const Vec3<T> along = loaded.H.transpose() * load.arm;
  out.virial += skew(semi) / T(2) + quasi.cross(along) * along.transpose() / along.squaredNorm();
  out.virial_size += semi.norm() + quasi.norm();
  out.reach = load.point.norm() + loaded.o.norm();
  return out;
}

/// Loads that balance the joint's load on b, axes of P_a, in the unknown directions.
template <class T, int n>
struct Applied {
  Eigen::Matrix<T, n, 1> load;
  Eigen::Matrix<T, n, n> tangent;  ///< by the relative position and spin of b
  Eigen::Matrix<T, n, 1> size;     ///< of what was added up: its rounding is that of the load
};

/// Such a load times a factor.
template <class T, int n>
Applied<T, n> operator*(const T& factor, const Applied<T, n>& applied) {
  using std::abs;
  return {factor * applied.load, factor * applied.tangent, T(abs(factor)) * applied.size};
}
template <class T, int n>
Applied<T, n>& operator+=(Applied<T, n>& to, const Applied<T, n>& more) {
  to.load += more.load;
  to.tangent += more.tangent;
  to.size += more.size;
  return to;
}

/// At load factor 1. @param R  relative rotation P_a^T P_b
template <Kind kind, class T>
Applied<T, unknown_count(kind)> applied(const JointLoad<T>& load, const Mat3<T>& R) {
  constexpr int n = unknown_count(kind);
  const auto turned = [&](const Vec3<T>& clamped) { return load.on_a ? Vec3<T>(R * clamped) : clamped; };
  const Vec3<T> f = turned(load.force);
  Applied<T, n> out;
  out.tangent.setZero();
  if constexpr (kind != Kind::angular) {
    const Vec3<T> pushed = load.on_a ? load.follower_force : Vec3<T>(R * load.follower_force);
    out.load.template head<3>() = f + pushed;
    out.size.template head<3>().setConstant(f.norm() + pushed.norm());
    if constexpr (kind != Kind::linear)
      out.tangent.template topRightCorner<3, 3>() = -skew(load.on_a ? f : pushed);
  }
  if constexpr (kind != Kind::linear) {
    const Vec3<T> fixed = turned(load.moment);
    const Vec3<T> follower = load.on_a ? load.follower_moment : Vec3<T>(R * load.follower_moment);
    // V = sum of f r^T, both seen from a: r x f is the axial vector of V - V^T, and [f][r] = V^T - tr V.
    const Mat3<T> V = load.on_a ? Mat3<T>(R * load.virial) : Mat3<T>(load.virial * R.transpose());
    const Mat3<T> trace = V.trace() * Mat3<T>::Identity();
    out.load.template tail<3>() =
        fixed + follower + Vec3<T>(V(2, 1) - V(1, 2), V(0, 2) - V(2, 0), V(1, 0) - V(0, 1));
    // What turns with the unknown rotation: the fixed directions seen from a, or the loaded frame seen from
    // a.
    out.tangent.template bottomRightCorner<3, 3>() =
        load.on_a ? Mat3<T>(trace - V - skew(fixed)) : Mat3<T>(V.transpose() - trace - skew(follower));
    out.size.template tail<3>().setConstant(fixed.norm() + follower.norm() + load.virial_size);
  }
  if (load.on_a) {
    out.load = -out.load;
    out.tangent = -out.tangent;
  }
  return out;
}

}  // namespace halfway
