// Second-order theory of the joint's response, an independent road to small-load equilibria.
#pragma once

#include "halfway/rotations/scalar.hpp"

namespace halfway::reference {

/// Rotation of node b under a fixed moment m to second order in m, node a clamped.
/// From m = K theta + alpha theta x K theta + beta k* (t2 t3, t3 t1, t1 t2) with F = K^-1 diagonal,
/// k* = k1 - k2 + k3: theta = F m - F (alpha (F m) x m + beta k* (..)). For the scene C2:
/// theta_2 = alpha F2 (F1 - F3) m1 m3.
template <class T>
Vec3<T> second_order_rotation(const Vec3<T>& F, const Vec3<T>& m, const T& alpha, const T& beta) {
  const Vec3<T> t = F.cwiseProduct(m);
  const T k = T(1) / F[0] - T(1) / F[1] + T(1) / F[2];
  const Vec3<T> products(t[1] * t[2], t[2] * t[0], t[0] * t[1]);
  const Vec3<T> second = alpha * t.cross(m) + beta * k * products;
  return t - F.cwiseProduct(second);
}

/// Rotation of node b under a fixed force f at its joint point, law without coupling: the moment of
/// the force at node b is -xi p x f with p = F_u f, hence theta = xi F_psi (p x f) to second order.
template <class T>
Vec3<T> second_order_bending(const Vec3<T>& F_u, const Vec3<T>& F_psi, const Vec3<T>& f, const T& xi) {
  const Vec3<T> p = F_u.cwiseProduct(f);
  return xi * F_psi.cwiseProduct(p.cross(f));
}

}  // namespace halfway::reference
