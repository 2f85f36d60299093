// One formulation in one scene as an equation in the joint's own pose and the load factor.
//
// The state is joint frame b seen from joint frame a, x = P_a^T d and R = P_a^T P_b: identity where nothing
// is strained, whatever the frames, the offsets and the place of the scene.
#pragma once

#include "halfway/equilibrium.hpp"
#include "reference/face/registry.hpp"
#include "reference/numbers/linear_algebra.hpp"
#include "reference/scene/scene.hpp"

#include <string>

namespace halfway::reference {

/// How the scene is posed: what must not change a sound answer.
struct Setting {
  bool nodes_exchanged = false;                     ///< the clamped node is listed as b (C8)
  Vec3<double> frame_turn = Vec3<double>::Zero();   ///< rotation vector of the whole scene, rad
  Vec3<double> frame_shift = Vec3<double>::Zero();  ///< displacement of the whole scene, m
};

/// A vector or matrix in the unknowns of a node: 3 or 6, without allocation.
template <class T>
using NodeVector = SmallVector<T>;
template <class T>
using NodeMatrix = SmallMatrix<T>;

/// The equation at one state and load factor, held loads included, in the unknown directions (dx, psi) as the
/// kind has them; at the joint point of the loaded node, axes of P_a, as loads on b; N, N m.
template <class T>
struct NodeBalance {
  NodeVector<T> imbalance;  ///< applied - internal
  NodeMatrix<T> tangent;    ///< d(internal - applied) / d(dx, psi)
  NodeVector<T> by_factor;  ///< d applied / d factor
  NodeVector<T> rounding;   ///< what rounding may leave of the imbalance
};

/// Equilibrium of the loaded node of a scene. T is double or Real50.
template <class T>
class EquilibriumProblem {
 public:
  /// References must outlive the problem. @param xi  for a formulation that has one.
  EquilibriumProblem(const Scene& scene, const Entry& entry, double xi, const Setting& setting = {});

  Kind kind() const { return spec_.kind; }
  /// 3 rotations, 3 displacements, or displacements and rotations.
  int unknowns() const { return strain_count(spec_.kind); }
  /// The unstrained state: the identity.
  Pose<T> start() const { return {}; }
  /// The loaded node at a state of the joint.
  Pose<T> node(const Pose<T>& joint) const;
  /// The state of the joint for a pose of the loaded node.
  Pose<T> joint(const Pose<T>& node) const;
  NodeBalance<T> balance(const Pose<T>& joint, const T& factor) const;
  /// At an equilibrium: the tangent of the loaded node, about the node and by (dx, w) of it, global axes.
  NodeMatrix<T> node_tangent(const Pose<T>& joint, const T& factor) const;
  /// A state moved by (dx, psi), each where it is unknown: R <- exp(psi) R.
  Pose<T> displaced(const Pose<T>& joint, const NodeVector<T>& step) const;
  /// theta_x, theta_y, theta_z (rotation vector of the loaded node, rad), u_x, u_y, u_z (its
  /// displacement, m), both from the unstrained pose and in the axes of the scene.
  T output(const std::string& name, const Pose<T>& joint) const;
  /// Estimated error of that output, rad or m.
  T output_error(const std::string& name, const Outcome<T>& state) const;
  /// The same output of the purely linear analysis: tangent of the unstrained pose, load of the
  /// unstrained pose. All formulations share it.
  T linear_output(const std::string& name, const T& factor) const;

  /// The equilibrium at load factor 0: the unstrained state, unless loads are held or the law has stresses
  /// there. It is reached in load steps in which what holds the joint unstrained is taken away as the held
  /// loads are put on. @param reached  set to how far that came, 0 ... 1
  Outcome<T> initial(T* reached = nullptr) const;
  /// From an equilibrium on to another load factor in load steps.
  Outcome<T> follow_to(const Outcome<T>& from, const T& factor_to,
                       const SolverOptions<T>& options = {}) const;
  /// The equilibrium next to a state, at one load factor.
  Outcome<T> equilibrium_near(const Pose<T>& joint, const T& factor) const;

 private:
  /// Of the loaded node from rest, axes of the clamped joint frame: its rotation vector and its displacement.
  Vec3<T> rotation(const Pose<T>& joint) const;
  Vec3<T> node_displacement(const Pose<T>& joint) const;
  /// In the axes of the scene: the component of theta or u that the name asks for, both given in the clamped
  /// frame.
  T component(const std::string& name, const Vec3<T>& theta, const Vec3<T>& u) const;
  /// The joint's load and its tangent, in the unknown directions.
  template <int n>
  Balance<T, n> internal(const Pose<T>& joint) const;
  /// What loads in the unknown directions are as a load on the joint while it is unstrained.
  JointLoad<T> as_joint_load(const NodeVector<T>& load) const;
  template <Kind kind>
  NodeBalance<T> balance_kind(const Pose<T>& joint, const T& factor) const;

  const Entry& entry_;
  JointSpec spec_;  ///< without ends: its nodes are the joint points
  JointEnd<T> a_, b_;
  bool exchanged_;
  Pose<T> clamped_;
  /// @param base, rate  acting is factor rate + base; base: nullptr for none
  Outcome<T> follow(const Outcome<T>& from, const T& factor_to, const JointLoad<T>& rate,
                    const JointLoad<T>* base, const SolverOptions<T>& options = {}) const;
  const JointLoad<T>* held() const { return has_held_ ? &held_ : nullptr; }

  JointLoad<T> load_, held_;  ///< those that grow with the load factor, and those that do not
  bool has_held_ = false;
};

}  // namespace halfway::reference
