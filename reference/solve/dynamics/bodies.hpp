// Rigid bodies and the joints between them: state, energy, momentum and rates of change.
//
// A body's node is its centre of mass, and its principal axes are the node's axes. A body may be clamped. The
// momenta, and not the velocities, are the state: what the joint does to them is then a plain sum.
#pragma once

#include "reference/face/registry.hpp"

#include <functional>
#include <vector>

namespace halfway::reference::dynamics {

using Vec4 = Eigen::Vector4d;
/// (f, m) of each body, global axes, moments about the nodes, conjugate to the motion of the nodes: what
/// would hold the joints in their places. The joints act on the bodies with the opposite.
using Loads = Eigen::VectorXd;

struct Body {
  double mass = 1;                              ///< kg
  Vec3<double> inertia = Vec3<double>::Ones();  ///< principal moments of inertia, kg m^2
  bool clamped = false;                         ///< does not move at all
};

struct BodyState {
  Vec3<double> x = Vec3<double>::Zero();  ///< centre of mass, global axes, m
  Vec4 q{1, 0, 0, 0};                     ///< unit quaternion (w, x, y, z), body axes -> global axes
  Vec3<double> p = Vec3<double>::Zero();  ///< momentum, kg m/s
  Vec3<double> L =
      Vec3<double>::Zero();  ///< angular momentum about the centre of mass, global axes, kg m^2/s
};

using State = std::vector<BodyState>;

/// A joint and its nodes: places in the list of bodies.
struct Joint {
  JointSpec spec;
  std::size_t a = 0, b = 1;
};

struct System {
  std::vector<Body> bodies;
  std::function<void(const State&, Loads&)> loads;    ///< sets all of them
  std::function<double(const State&)> strain_energy;  ///< J
  std::function<double(const State&)> dissipation{};  ///< W, what a damper takes out; empty: none
  /// Sets (f, m) of each body that act on it from outside at a time, s, as `loads`; empty: none.
  std::function<void(double, const State&, Loads&)> drive{};
};

/// How far a motion is, s, and what System::drive has worked until then, J.
struct Driven {
  double time = 0, work = 0;
};

/// Bodies on joints of a formulation: its loads by the kernel where it has one, its law's own strain energy
/// whether or not the loads derive from it. References must outlive the result. Laws must be linear.
System elastic_system(const Entry& entry, const std::vector<Joint>& joints, const std::vector<Body>& bodies);

/// Bodies without any joint.
System free_system(const std::vector<Body>& bodies);

/// Body axes -> global axes; q need not be normalised.
Mat3<double> orientation(const Vec4& q);

/// The node of a body, its quaternion normalised.
Pose<double> node_pose(const BodyState& state);

/// Angular velocity in global axes (rad/s).
Vec3<double> spin(const Body& body, const BodyState& state);

Vec3<double> velocity(const Body& body, const BodyState& state);

/// J.
double kinetic_energy(const System& system, const State& state);
double energy(const System& system, const State& state);

/// Of all bodies, the angular one about the origin of the global axes.
struct Momenta {
  Vec3<double> linear, angular;
};
Momenta momenta(const State& state);

/// The momenta of a body from its motion. @param v, w  velocity (m/s) and spin (rad/s), global axes
void set_motion(const Body& body, const Vec3<double>& v, const Vec3<double>& w, BodyState& state);

/// Relative rotation of a joint's two frames, rad, in [0, pi]; the largest of all.
double relative_angle(const std::vector<Joint>& joints, const State& state);

}  // namespace halfway::reference::dynamics
