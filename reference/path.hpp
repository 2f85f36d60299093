// One formulation on its way through one scene, in double or at 50 digits.
#pragma once

#include "formulations/equilibrium.hpp"
#include "reference/registry.hpp"
#include "reference/scene.hpp"

#include <string>

namespace halfway::reference {

/// How the scene is posed: what must not change a sound answer.
struct Setting {
  bool nodes_exchanged = false;                     ///< the clamped node is listed as b (C8)
  Vec3<double> frame_turn = Vec3<double>::Zero();   ///< rotation vector of the whole scene, rad
  Vec3<double> frame_shift = Vec3<double>::Zero();  ///< displacement of the whole scene, m
};

/// The equilibrium path of a scene, from the unstrained pose on. T is double or Real50.
template <class T>
class Path {
 public:
  /// References must outlive the path. @param xi  for a formulation that has one.
  Path(const Scene& scene, const Entry& entry, double xi, const Setting& setting = {});

  /// Goes on to a load factor; the state is the last equilibrium reached, converged or not.
  const Outcome<T>& advance(double factor);

  const Outcome<T>& state() const { return state_; }

  /// theta_x, theta_y, theta_z (rotation vector of the loaded node, rad), u_x, u_y, u_z (its
  /// displacement, m), both from the unstrained pose and in the axes of the scene.
  T output(const std::string& name) const;

  /// The same output of the purely linear analysis: tangent of the unstrained pose, load of the
  /// unstrained pose. All formulations share it.
  T linear_output(const std::string& name, double factor) const;

 private:
  /// In the axes of the scene: the component of theta or u that the name asks for.
  static T component(const std::string& name, const Vec3<T>& theta, const Vec3<T>& u);
  template <Kind kind>
  Eigen::Matrix<T, unknown_count(kind), 1> linear_response(const T& factor) const;

  template <Kind kind>
  Balance<T, unknown_count(kind)> internal(const Pose<T>& moving) const;
  template <Kind kind>
  Outcome<T> follow_to(const T& factor) const;

  const Entry& entry_;
  JointSpec spec_;
  bool exchanged_;
  Pose<T> clamped_;
  Pose<T> start_;
  NodeLoad<T> load_;
  Outcome<T> state_;
};

}  // namespace halfway::reference
