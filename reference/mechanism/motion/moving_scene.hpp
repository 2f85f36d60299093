// A scene in time as the integrators take it: bodies about their centres of mass, in principal axes.
//
// A body that only turns does so about its node, and is one of the inertia about it. Joints are elastic by
// their formulation; their dampers are those of the half-way strains, whatever the formulation, so that
// formulations differ by their springs alone and no damper makes energy.
#pragma once

#include "halfway/damping.hpp"
#include "reference/scene/mechanism_scene.hpp"
#include "reference/solve/dynamics/bodies.hpp"
#include "reference/solve/solve.hpp"

namespace halfway::reference::mechanism {

/// Where the scene's bodies are and how they move: of their nodes, global axes.
struct Moving {
  std::vector<Pose<double>> nodes;
  std::vector<Twist<double>> twists;
};

class MovingScene {
 public:
  /// The scene must outlive it. @param begin  the bodies' nodes at the start, global axes
  MovingScene(const MechanismScene& scene, const Choice& choice, const std::vector<Pose<double>>& begin);
  MovingScene(const MovingScene&) = delete;
  MovingScene& operator=(const MovingScene&) = delete;

  const MechanismScene& scene() const { return scene_; }
  /// Driven by nothing: `drive` is of who knows on which part of the way he is.
  const dynamics::System& system() const { return system_; }
  const dynamics::State& start() const { return start_; }

  Moving moving(const dynamics::State& state) const;
  const Pose<double>& rest(std::size_t body) const { return rest_[body]; }
  /// The joint without its damper, with the choice's xi.
  const JointSpec& spec(std::size_t joint) const { return specs_[joint]; }
  const Entry& entry() const { return entry_; }

  /// What the joint's damper and its springs do together, (f_a, m_a, f_b, m_b) as NOTATION has them.
  Eigen::Matrix<double, 12, 1> joint_loads(std::size_t joint, const Moving& now) const;
  /// W, what its damper takes.
  double joint_power(std::size_t joint, const Moving& now) const;
  /// What the loads do at a time, on the straight part of the way of each that a second time, s, is on: at
  /// its ends an integrator looks beyond.
  void set_drive(double time, double on_part, const dynamics::State& state, dynamics::Loads& sum) const;
  dynamics::Momenta momenta(const dynamics::State& state) const;
  /// Of a joint's relative rotation, rad.
  Vec3<double> relative_rotation(std::size_t joint, const Moving& now) const;

 private:
  struct Mass {
    Vec3<double> center = Vec3<double>::Zero();    ///< what the integrators move, axes of the body, m
    Mat3<double> axes = Mat3<double>::Identity();  ///< principal axes -> axes of the body
  };
  void add_body(const SceneBody& body);
  void add_start(const SceneBody& body, const Pose<double>& node);
  Damping<double> damper(std::size_t joint, const Moving& now) const;
  void set_loads(const dynamics::State& state, dynamics::Loads& sum) const;
  /// What acts on a body about its node, carried to its centre; without what a held body does not feel.
  void add_to_body(std::size_t body, const Pose<double>& node, const Vec3<double>& f, const Vec3<double>& m,
                   dynamics::Loads& sum) const;
  double dissipation(const dynamics::State& state) const;
  double strain_energy(const dynamics::State& state) const;

  const MechanismScene& scene_;
  const Entry& entry_;
  std::vector<Pose<double>> rest_;
  std::vector<JointSpec> specs_;
  std::vector<Mass> masses_;
  std::vector<JointLoad<double>> loads_;  ///< about the node, from its orientation at rest
  dynamics::System system_;
  dynamics::State start_;
};

}  // namespace halfway::reference::mechanism
