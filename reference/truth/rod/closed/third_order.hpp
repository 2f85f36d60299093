// What a rod that is short of a turn does, to third order, and what a taper changes at second.
#pragma once

#include "reference/truth/rod/rod.hpp"

namespace halfway::reference::rod::closed {

/// The moment of a straight uniform rod under an end moment, in the half-way frame exp(theta/2), by its
/// rotation theta, to third order (Magnus' series of R' = R [C R^T m], derived here):
///   w - theta x (theta x w)/24 - (K (theta x v) + v x w)/12,  w = K theta,  v = K^-1 (w x theta).
/// The error is of fifth order; it has the energy theta . w/2 - (w x theta) . v/24.
/// @param K  stiffness of the joint that stands for the rod at zero: symmetric, positive definite, N m/rad
Vec3<double> third_order_moment(const Mat3<double>& K, const Vec3<double>& theta);

/// xi of each component of the second-order law m_i = (K theta)_i + xi_i (theta x K theta)_i of a straight
/// tapered rod, K^-1 = diag(Cb), from the clamp:
///   xi_i = (int C_i (G_k - G_j) + int (G_j C_k - G_k C_j)/2)/(Cb_i (Cb_k - Cb_j)),  G(s) = int_0^s C,  Cb =
///   G(length),
/// i, j, k cyclic; derived here. They are 1/2 where all C_i have the same shape.
/// Throws std::invalid_argument where two of Cb are equal: that component says nothing about its xi.
Vec3<double> xi_of_taper(const std::function<Section(double s)>& taper, double length);

}  // namespace halfway::reference::rod::closed
