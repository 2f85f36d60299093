// A clamped-free uniform rod under a dead force and moment at its tip, integrated here from the tip back to
// the clamp: there the loads are known, and nothing has to be guessed.
#pragma once

#include "verify/oracle/probes.hpp"

namespace halfway::verify {

/// Section stiffnesses, axis 1 along the rod, and length.
struct UniformRod {
  Vec3<double> bending;  ///< GJ, EI2, EI3, N m^2
  double axial = 1e8;    ///< EA, N
  double shear = 1e8;    ///< GA of either direction, N
  double length = 1;     ///< m
};

/// The joint of one rod at its middle: stiffness as (d1, d2, d3, theta1, theta2, theta3), of a straight rod
/// with shear.
Eigen::VectorXd middle_stiffness(const UniformRod& rod);

/// The rod's ends seen from its clamp, in its axes.
struct BentRod {
  Pose<double> tip;            ///< m; the clamp is at the origin
  Vec3<double> force, moment;  ///< on the tip, N, N m
};
/// @param force, moment  on the tip, in the tip's own axes, N and N m
BentRod bent_rod(const UniformRod& rod, const Vec3<double>& force, const Vec3<double>& moment);

/// The rotation of the tip under a fixed moment alone, in the axes of the clamp, N m: R' = R [K^-1 R^T m]
/// from the clamp on. @param K  of the whole rod, N m/rad, any symmetric positive definite
Mat3<double> turned_by_moment(const Mat3<double>& K, const Vec3<double>& moment);

}  // namespace halfway::verify
