// One formulation in one scene as an equation in the pose of the loaded node and the load factor.
#pragma once

#include "halfway/equilibrium.hpp"
#include "reference/face/registry.hpp"
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
using NodeVector = Eigen::Matrix<T, Eigen::Dynamic, 1, 0, 6, 1>;
template <class T>
using NodeMatrix = Eigen::Matrix<T, Eigen::Dynamic, Eigen::Dynamic, 0, 6, 6>;

/// The equation at one pose and load factor, in the unknown directions (dx_b, w_b) as the kind has
/// them; global axes, N, N m.
template <class T>
struct NodeBalance {
  NodeVector<T> imbalance;  ///< applied - internal
  NodeMatrix<T> tangent;    ///< d(internal - applied) / d(dx_b, w_b)
  NodeVector<T> by_factor;  ///< d applied / d factor
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
  /// The unstrained pose of the loaded node.
  const Pose<T>& start() const { return start_; }
  NodeBalance<T> balance(const Pose<T>& b, const T& factor) const;
  /// b displaced by (dx, w), each where it is unknown: R <- exp(w) R.
  Pose<T> displaced(const Pose<T>& b, const NodeVector<T>& step) const;
  /// theta_x, theta_y, theta_z (rotation vector of the loaded node, rad), u_x, u_y, u_z (its
  /// displacement, m), both from the unstrained pose and in the axes of the scene.
  T output(const std::string& name, const Pose<T>& b) const;
  /// The same output of the purely linear analysis: tangent of the unstrained pose, load of the
  /// unstrained pose. All formulations share it.
  T linear_output(const std::string& name, const T& factor) const;
  /// From an equilibrium on to another load factor in load steps.
  Outcome<T> follow_to(const Pose<T>& from, const T& factor_from, const T& factor_to) const;

 private:
  /// In the axes of the scene: the component of theta or u that the name asks for.
  T component(const std::string& name, const Vec3<T>& theta, const Vec3<T>& u) const;
  /// Load of the joint on the loaded node and its tangent, in the unknown directions.
  template <int n>
  Balance<T, n> internal(const Pose<T>& moving) const;
  template <Kind kind>
  Outcome<T> follow_kind(const Pose<T>& from, const T& factor_from, const T& factor_to) const;
  template <Kind kind>
  NodeBalance<T> balance_kind(const Pose<T>& b, const T& factor) const;

  const Entry& entry_;
  JointSpec spec_;
  bool exchanged_;
  Pose<T> clamped_;
  Pose<T> start_;
  NodeLoad<T> load_;
};

}  // namespace halfway::reference
