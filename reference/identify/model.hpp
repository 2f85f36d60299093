// What is to be identified, as numbers: a joint of the catalog in its principal axes, and what it lacks at
// second order.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/identify/data.hpp"

namespace halfway::reference::identify {

/// Places of the unknowns in a vector. Stiffnesses as logarithms of their ratio to a reference, so that they
/// stay positive; lengths over Frame::length, the cubic terms over the stiffness that they change.
enum Place {
  kAngularStiffness = 0,  ///< 3: about the principal axes
  kAngularAxes = 3,       ///< 3: rotation vector of the axes from Frame::H, rad
  kLinearStiffness = 6,   ///< 3
  kLinearAxes = 9,        ///< 3: of the axes of the translations, from Frame::E
  kCoupling = 12,         ///< 6: what moving the joint point does not decouple, S_11 S_22 S_33 S_23 S_13 S_12
  kJointPoint = 18,       ///< 3
  kXiAngular = 21,        ///< 3: of the rotation about axis i under moments about the two others
  kXiLinear = 24,         ///< 3: of the rotation about axis i under forces along the two others
  kCubic = 27,            ///< 1: c of the energy c theta_1 theta_2 theta_3, over the mean stiffness
  kAngularCube = 28,      ///< 3: k3 of the axis laws k1 e + k3 e^3, over k1/Frame::turn^2
  kLinearCube = 31,       ///< 3: over k1/Frame::reach^2
  kPlaces = 34
};
using Unknowns = Eigen::Matrix<double, kPlaces, 1>;

/// What the unknowns are measured from.
struct Frame {
  Kind kind = Kind::linear_angular;
  Mat3<double> H = Mat3<double>::Identity();  ///< principal axes of rotations -> global axes
  Mat3<double> E =
      Mat3<double>::Identity();  ///< principal axes of translations -> H (of a linear joint: -> global)
  Vec3<double> angular{1, 1, 1}, linear{1, 1, 1};  ///< N m/rad, N/m
  double length = 1;                               ///< m
  double turn = 1, reach = 1;                      ///< of the data: largest rotation and displacement, rad, m
};

/// The unknowns as a person reads them.
struct JointValues {
  Vec3<double> angular, linear;  ///< principal stiffnesses, N m/rad, N/m
  Mat3<double> H, E;
  Mat3<double> S;      ///< symmetric, m: F_um = -S F_psi at the joint point, joint axes
  Vec3<double> point;  ///< joint point from node b at rest, global axes, m
  Vec3<double> xi_angular, xi_linear;
  double cubic;                            ///< N m/rad^2
  Vec3<double> angular_cube, linear_cube;  ///< N m/rad^3, N/m^3
};
JointValues values_of(const Frame& frame, const Unknowns& p);

/// No second order but the half-way frame's, no coupling.
Unknowns no_unknowns();

/// A joint that can be asked for loads: a formulation of the catalog, and terms of second order beside it.
struct Model {
  const Entry* entry = nullptr;
  JointSpec spec{};
  Vec3<double> pair{0, 0, 0};  ///< m_i += pair_i theta_j theta_k, joint axes, N m/rad^2: no potential
  double cubic = 0;            ///< energy cubic theta_1 theta_2 theta_3
  Vec3<double> bending{
      0, 0, 0};  ///< energy -sum bending_k theta_k (p x K_u p)_k: xi of the forces beyond the frame's
  Mat3<double> K_u = Mat3<double>::Zero();
};

/// The law that all formulations share: linear; where a cube is not zero a polynomial of each strain, along
/// one set of axes for rotations and translations (those of H; of a linear joint those of E) and without
/// coupling.
JointSpec joint_spec(const Frame& frame, const JointValues& v);

/// Second order by one xi (those of `v` are equal): the formulation `intrinsic` as it is. By several: that of
/// their mean, or of the node it lies beyond, and what they are beside it. With a cubic term: `potential` and
/// that term, exactly conservative.
Model second_order_model(const Frame& frame, const JointValues& v);

/// Another formulation of the catalog, with the same law.
Model catalog_model(const Entry& entry, const Frame& frame, const JointValues& v);

/// Loads on node b by its motion, and their derivative by the motion (u, theta).
struct Loads {
  Vec6 q;
  Mat6 by_motion;
};
Loads loads_at(const Model& model, const Vec6& motion, bool with_derivative);

}  // namespace halfway::reference::identify
