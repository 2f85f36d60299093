// Game and robotics engines whose joints are one composition each.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// The angles of Rz Ry Rx, moments along the reciprocal axes shortened to one, the force of each body at its
/// own anchor. Defects: moments do not balance; work round a loop even with one stiffness; lost at e_y = 90
/// degrees.
struct Bullet6Dof : Composed<FrameA, EulerMeasure<2, 1, 0>, AlongReciprocal<2, 1, 0>, Own> {
  static constexpr const char* name = "bullet_6dof";
  static constexpr const char* stands_for = "Bullet btGeneric6DofSpringConstraint; Spring2 without its clamp";
  static constexpr ProgramFacts facts{.source = "Bullet 3.24, 5e-15", .balanced = false};
};

/// The same with setUseFrameOffset(false), or with pull request 4438: both forces at b's anchor.
struct Bullet6DofAtB : Composed<FrameA, EulerMeasure<2, 1, 0>, AlongReciprocal<2, 1, 0>, AtB> {
  static constexpr const char* name = "bullet_6dof_at_b";
  static constexpr const char* stands_for = "Bullet btGeneric6DofSpringConstraint, setUseFrameOffset(false)";
  static constexpr ProgramFacts facts{.source = "Bullet 3.24, 5e-15"};
};

/// Defects: the swing moment folds at 90 degrees; work round a loop even with one stiffness.
struct PhysxSwingTwist : Composed<FrameA, SwingTwistMeasure, Along<FrameA>, AtB> {
  static constexpr const char* name = "physx_swing_twist";
  static constexpr const char* stands_for = "PhysX D6 swing-twist drives (Unity, Isaac, O3DE)";
  static constexpr ProgramFacts facts{.source = "PhysX 5.6.1 (npm physx-js-webidl 2.7.3), 5e-6"};
};

/// Defect: a quarter of the stiffness asked for, with its peak at 90 degrees.
struct PhysxSlerp : Composed<FrameA, QuarterSineMeasure, Along<FrameA>, AtB> {
  static constexpr const char* name = "physx_slerp";
  static constexpr const char* stands_for = "PhysX D6 SLERP drive";
  static constexpr ProgramFacts facts{.source = "PhysX 5.6.1 (npm physx-js-webidl 2.7.3), 9e-6",
                                      .isotropic_conservative = true,
                                      .tensorial = true,
                                      .isotropic_moments = true};
};

/// Two frames in one joint: forces along the axes of a, moments along those of b. No potential.
struct Jolt6Dof : Composed<FrameA, QuaternionMeasure, Along<FrameB>, AtB> {
  static constexpr const char* name = "jolt_6dof";
  static constexpr const char* stands_for = "Jolt SixDOFConstraint motors (Godot 4)";
  static constexpr ProgramFacts facts{
      .source = "Jolt (npm jolt-physics 1.1.0), 3e-6", .isotropic_conservative = true, .tensorial = true};
};

struct RapierAsin : Composed<FrameA, AsinMeasure, Along<FrameA>, AtB> {
  static constexpr const char* name = "rapier_asin";
  static constexpr const char* stands_for = "Rapier GenericJoint motors";
  static constexpr ProgramFacts facts{.source = "Rapier (npm @dimforge/rapier3d-compat 0.21.0), 2e-6"};
};

/// The angles of Rx Ry Rz along the gimbal axes, not their reciprocals; each force at its own anchor.
struct NewtonD6 : Composed<FrameA, EulerMeasure<0, 1, 2>, AlongGimbal<0, 1, 2>, Own> {
  static constexpr const char* name = "newton_d6";
  static constexpr const char* stands_for = "Newton / Warp semi-implicit D6 joint";
  static constexpr ProgramFacts facts{.known = Known::read_in_source,
                                      .source = "newton, semi_implicit/kernels_body.py @41a5392",
                                      .balanced = false};
};

/// Stretch and shear are not known; the moments are conjugate, so they do no work round a loop.
struct NewtonRod : Composed<FrameA, BinormalMeasure, ByRate<BinormalMeasure>, AtB> {
  static constexpr const char* name = "newton_rod";
  static constexpr const char* stands_for = "Newton VBD rod, bend and twist (axis z)";
  static constexpr ProgramFacts facts{.known = Known::read_in_source,
                                      .source = "newton, vbd/rigid_vbd_kernels.py",
                                      .isotropic_conservative = true,
                                      .anisotropic_conservative = true,
                                      .has_forces = false};
};

/// The angles of Rx Ry Rz along the reciprocal axes shortened to one.
struct OdeAMotor : Composed<FrameA, EulerMeasure<0, 1, 2>, AlongReciprocal<0, 1, 2>, Own> {
  static constexpr const char* name = "ode_amotor";
  static constexpr const char* stands_for = "ODE Ball + AMotor (Euler) with stops as springs";
  static constexpr ProgramFacts facts{.source = "ODE 0.16.2, 6e-15", .isotropic_forces = true};
};

/// One stiffness each, the world's for rotation: the joint's own ERP and CFM reach the translation alone. It
/// works at b's centre of mass, which is where its joint point has to be.
struct OdeFixed : Composed<FrameA, QuaternionMeasure, Along<FrameA>, Own> {
  static constexpr const char* name = "ode_fixed";
  static constexpr const char* stands_for = "ODE Fixed joint made soft";
  static constexpr ProgramFacts facts{.source = "ODE 0.16.2, 6e-15",
                                      .order_free = true,
                                      .isotropic_conservative = true,
                                      .tensorial = true,
                                      .isotropic_moments = true,
                                      .isotropic_forces = true};
};

/// Entries of the matrix; the program warns that it "may be wrong for spatial rotation".
struct MbsimOffdiag : Composed<FrameA, EntryMeasure, Along<FrameA>, AtB> {
  static constexpr const char* name = "mbsim_offdiag";
  static constexpr const char* stands_for = "MBSim ElasticJoint";
  static constexpr ProgramFacts facts{.known = Known::read_in_source,
                                      .source = "MBSim, elastic_joint.cc @07dc462"};
};

/// The other entries, with their conjugate moments.
struct FebioGeneric : Composed<FrameA, OtherEntryMeasure, ByRate<OtherEntryMeasure>, AtB> {
  static constexpr const char* name = "febio_generic";
  static constexpr const char* stands_for = "FEBio generic rigid joint (penalty)";
  static constexpr ProgramFacts facts{.known = Known::read_in_source,
                                      .source = "FEBio, FEGenericRigidJoint.cpp",
                                      .isotropic_conservative = true,
                                      .anisotropic_conservative = true};
};

}  // namespace halfway::programs
