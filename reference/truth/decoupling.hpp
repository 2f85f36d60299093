// Decoupling of a 6x6 compliance (translation first): where forces and moments part [47-50].
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "halfway/rotations/scalar.hpp"

namespace halfway::reference {

/// With (f, m) = [[1, 0], [A, 1]] (f*, m*) the off-diagonal block of the compliance vanishes.
template <class T>
struct Decoupling {
  Mat3<T> A;           ///< -F_psim^-1 F_um^T
  Vec3<T> x;           ///< joint point from the free node, m: the nearest skew part of A is [x]
  Mat3<T> remainder;   ///< A - [x]: zero when moving the joint point is enough
  Mat3<T> F_u, F_psi;  ///< decoupled compliances, m/N and rad/(N m)
};

template <class T>
Decoupling<T> decouple(const Eigen::Matrix<T, 6, 6>& F) {
  const Mat3<T> F_uf = F.template topLeftCorner<3, 3>();
  const Mat3<T> F_um = F.template topRightCorner<3, 3>();
  const Mat3<T> F_psim = F.template bottomRightCorner<3, 3>();
  Decoupling<T> d;
  d.A = -F_psim.partialPivLu().solve(Mat3<T>(F_um.transpose()));
  d.x = axial(d.A);
  d.remainder = d.A - skew(d.x);
  d.F_u = F_uf + F_um * d.A;
  d.F_psi = F_psim;
  return d;
}

}  // namespace halfway::reference
