// Scenes of mechanisms: bodies and the joints between them, loads, prescribed motion.
#pragma once

#include "halfway/equilibrium.hpp"
#include "reference/face/in_scalar.hpp"
#include "reference/face/registry.hpp"
#include "reference/scene/scene.hpp"

#include <optional>
#include <string>
#include <vector>

namespace halfway::reference {

/// The body that never moves: the global axes.
inline constexpr const char* kGround = "ground";

/// Where and how a body begins its motion, global axes; of its node.
struct SceneStart {
  Vec3<double> theta = Vec3<double>::Zero();     ///< rotation vector from its pose at rest, rad
  Vec3<double> u = Vec3<double>::Zero();         ///< displacement from there, m
  Vec3<double> velocity = Vec3<double>::Zero();  ///< m/s
  Vec3<double> spin = Vec3<double>::Zero();      ///< rad/s
  bool is_spin_of_body = false;                  ///< the spin is given in axes of the body
};

struct SceneBody {
  std::string name;
  std::optional<Pose<double>> pose{};  ///< of its node while nothing is loaded; none: where its joints rest
  /// What is unknown of it, as of the loaded node of a joint of that kind; none: it is clamped.
  std::optional<Kind> moves = Kind::linear_angular;
  double mass = 0;                              ///< kg; 0: not said
  Vec3<double> center = Vec3<double>::Zero();   ///< of mass, axes of the body, m
  Mat3<double> inertia = Mat3<double>::Zero();  ///< about the centre of mass, axes of the body, kg m^2
  SceneStart start{};                           ///< of a scene in time
};

struct SceneJoint {
  std::string name;
  JointSpec spec;
  bool has_length = false;  ///< does the file say its rod?
  int a = 0, b = 0;         ///< its nodes' bodies, by their place
  /// Kelvin-Voigt, of the rates of half-way strains whatever the formulation; N s/m, N m s/rad; none: 0 x 0.
  Eigen::MatrixXd damping{};
};

/// How a load or a motion grows: with the load factor, or by these multipliers at the end of each step.
using Factors = std::vector<double>;

struct BodyLoad : SceneLoad {
  int body = 0;
  Factors factors{};
  /// Of a scene in time: those of the factors, s; straight in between. Twice the same is a jump.
  std::vector<double> times{};
};

/// How a scene in time is integrated.
enum class Integrator { runge_kutta, splitting_2, splitting_4 };
inline constexpr const char* kIntegrators[] = {"runge_kutta", "splitting_2", "splitting_4"};
struct SceneTime {
  Integrator integrator = Integrator::runge_kutta;
  double tolerance = 1e-9;  ///< of a step of runge_kutta, relative and in SI units
  double step = 0;          ///< largest of a splitting, s
  long most_steps =
      400'000;  ///< of runge_kutta: tens of thousands of periods, some ten seconds a formulation
  /// Bodies begin where the loads of time 0 are balanced, those that jump there before they do.
  bool from_equilibrium = false;
};

/// What a body is made to do, from its pose while nothing is loaded.
struct SceneMotion {
  std::string name;
  int body = 0;
  bool is_rotation = false;  ///< or displacement of `point`
  int axis = -1;             ///< global axis 0, 1, 2 of the component that is prescribed; -1: all
  Vec3<double> value = Vec3<double>::Zero();  ///< rotation vector, rad, or displacement, m, global axes
  Vec3<double> point = Vec3<double>::Zero();  ///< axes of the body, m
  Factors factors{};
};

/// Outputs: theta and u of each body, NAME.theta_x ... u_z (without NAME: of body b), from its pose while
/// nothing is loaded, global axes; NAME.a.f_x ... NAME.b.m_z, what a joint exerts on the body at either node,
/// N and N m about the node, global axes; NAME.strain_1 ...; NAME.energy, energy: J; NAME.f_x ... m_z of a
/// motion: what it exerts on its body; frequency_1 ... (Hz), growth (1/s), eigenvalue_1 ... of the tangent's
/// symmetric part. In time besides: NAME.v_x ..., NAME.w_x ..., velocity and spin of a body's node, m/s and
/// rad/s; NAME.power, what a joint's damper takes, W; kinetic, dissipated, work (of the loads) and balance =
/// kinetic + energy + dissipated - work since the start, J; p_x ..., L_x ..., momenta of all bodies, the
/// angular one about the origin, kg m/s and kg m^2/s; none of modes.
struct MechanismScene : SceneHead {
  std::vector<SceneBody> bodies;  ///< the first is the ground
  std::vector<SceneJoint> joints;
  std::vector<BodyLoad> loads;
  std::vector<SceneMotion> motions;
  int steps = 0;                    ///< of the path: the load factor counts them; 0: none are named
  std::optional<SceneTime> time{};  ///< the scene is a motion from its start on, and has no path
};

/// How many unknowns the bodies have; those that are prescribed are among them.
int unknown_count(const MechanismScene& scene);
/// How many of them are prescribed.
int prescribed_count(const MechanismScene& scene);

/// What a formulation has against a joint of it, as "which takes no coupling" goes on; "": nothing.
std::string mechanism_objection(const Entry& entry, const MechanismScene& scene);

/// Where the bodies are while nothing is loaded: as they say, or where the first joint from a placed body
/// is at rest. None where no joint leads there.
template <class T>
std::vector<std::optional<Pose<T>>> initial_poses(const MechanismScene& scene) {
  std::vector<std::optional<Pose<T>>> out;
  for (const SceneBody& body : scene.bodies) {
    out.emplace_back();
    if (body.pose) out.back() = Pose<T>{body.pose->x.template cast<T>(), rotation_in<T>(body.pose->R)};
  }
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const SceneJoint& joint : scene.joints) {
      const bool from_a = out[joint.a].has_value();
      if (from_a == out[joint.b].has_value()) continue;
      const JointEnd<T> a = end_in<T>(joint.spec.a), b = end_in<T>(joint.spec.b);
      if (from_a)
        out[joint.b] = unstrained<T>(a, b, *out[joint.a]);
      else
        out[joint.a] = node_a<T>(a, b, *out[joint.b], Pose<T>{});
      goes_on = true;
    }
  }
  return out;
}

}  // namespace halfway::reference
