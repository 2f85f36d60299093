// Moments on a free node: what keeps its direction and what turns with the node decides between
// divergence and flutter.
//
// All act about a global axis e3 (e1, e2, e3 right-handed) on node b with orientation R. A couple is two
// opposite dead forces F at the ends of an arm that is fixed in b: (R a) x F. At the angle `square_at` of
// a rotation about e3 the arms stand square to their forces: a_i = exp(-square_at e3) e_i.
//   fixed             M e3: the direction is global. Non-conservative at finite rotations
//   follower          M R e3: turns with b. Non-conservative
//   semi_tangential   M/2 [(R a1) x e2 - (R a2) x e1]: two equal couples
//   quasi_tangential  M (R a1) x e2: one couple
// Dead forces have the potential V = -sum F . (R a), so the last two are conservative at any rotation. Where
// the arms are square, their derivatives by the spin of b are -1/2 [m] + a symmetric part, which is zero for
// the semi-tangential one: half-way between fixed (0) and follower (-[m]).
#pragma once

#include "reference/numbers/dual.hpp"
#include "reference/numbers/precision.hpp"

#include <optional>

namespace halfway::reference {

enum class MomentType { fixed, follower, semi_tangential, quasi_tangential };
inline constexpr MomentType kMomentTypes[] = {MomentType::fixed, MomentType::follower,
                                              MomentType::semi_tangential, MomentType::quasi_tangential};
const char* to_string(MomentType type);

/// @param axis  0, 1 or 2: e3 above, global; e1 and e2 are the two next ones.
template <class T>
struct MomentLoad {
  MomentType type = MomentType::fixed;
  int axis = 2;
  T square_at{0};  ///< rad; read by moments that are couples
};

/// A moment on node b, global axes, N m, and its derivatives by the spin of b (global axes) and by M.
template <class T>
struct AppliedMoment {
  Vec3<T> m;
  Mat3<T> m_w;
  Vec3<T> m_M;
};

/// T is double, Real50 or Dual<Real50>. @param M  magnitude, N m. @param R  orientation of b.
template <class T>
AppliedMoment<T> applied_moment(const MomentLoad<T>& load, const T& M, const Mat3<T>& R);

/// V with power of the moment = -dV/dt, J; nothing for a moment that has none.
template <class T>
std::optional<T> moment_potential(const MomentLoad<T>& load, const T& M, const Mat3<T>& R);

/// Work, J, of a unit moment about axis 2 round Ziegler's loop: half a turn of b about axis 0, half a turn
/// about axis 1 (both global), and half a turn back about axis 2, which ends where it began.
/// Gauss quadrature of the power, exact to rounding.
double ziegler_work(MomentType type);

}  // namespace halfway::reference
