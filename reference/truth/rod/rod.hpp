// A geometrically exact rod, the truth at large rotation: Simo's (1985) rod that bends, twists, shears and
// stretches, clamped at s = 0 at the origin with its tangent along axis 1 of the global axes.
//
//   R' = R [kappa],  kappa = kappa0 + C_m R^T m,     C_m = diag(bending)
//   x' = R (e_1 + C_n R^T n),                         C_n = diag(stretching)
//   n' = 0,  m' = n x x'                              ' = d/ds, 0 <= s <= length
//
// n and m are what the part beyond s does to the part before it, in global axes: a tip carries (n,
// m)(length). Angles in rad, lengths in m, forces in N; any other coherent units will do.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <functional>
#include <vector>

namespace halfway::reference::rod {

/// What a section gives way by, along its own axes; axis 1 is the tangent's. Zero is rigid, none is negative.
struct Section {
  Vec3<double> bending{0, 0, 0};     ///< 1/GJ, 1/EI2, 1/EI3; curvature by moment, 1/(N m^2)
  Vec3<double> stretching{0, 0, 0};  ///< 1/EA, 1/GA2, 1/GA3; strain by force, 1/N
};

/// The section of stiffnesses (GJ, EI2, EI3), N m^2, and (EA, GA2, GA3), N; infinite ones are rigid.
/// Throws std::invalid_argument where one is not positive.
Section of_stiffness(const Vec3<double>& bending, const Vec3<double>& stretching);
/// One that neither stretches nor shears.
Section of_stiffness(const Vec3<double>& bending);

struct Rod {
  double length = 1;                         ///< m
  Section section{};                         ///< of every s where `taper` is not set
  Vec3<double> curvature0{0, 0, 0};          ///< without load, along the section's axes, rad/m
  std::function<Section(double s)> taper{};  ///< the section at s, smooth in s
};

/// Straight, and the same all along.
inline Rod straight(double length, const Section& section) {
  Rod out;
  out.length = length, out.section = section;
  return out;
}

/// What acts on the tip. A follower turns with the section at the tip, in whose axes it is given.
struct Loads {
  Vec3<double> force{0, 0, 0};            ///< fixed in space, N
  Vec3<double> moment{0, 0, 0};           ///< fixed in space, N m
  Vec3<double> follower_force{0, 0, 0};   ///< N
  Vec3<double> follower_moment{0, 0, 0};  ///< N m

  Loads operator*(double factor) const;
};

/// The end of the rod.
struct Tip {
  Vec3<double> x;    ///< m
  Mat3<double> R;    ///< axes of its section -> global axes
  double error = 0;  ///< of x over the length and of the entries of R, by a second solution: half the steps,
                     ///< or fewer polynomials
};

/// Under a fixed moment alone: m is the same vector all along, so an integration from the clamp gives the one
/// solution there is. Any rod, any moment.
Tip tip_under_moment(const Rod& rod, const Vec3<double>& moment);

/// The same of the moments `amounts[i] * direction`, in ascending order from 0 on, of a straight uniform rod:
/// one integration gives the whole load curve, because R(s; a m) = R(a s; m). The rod is a free Euler top
/// with angular momentum m and time s. Throws std::invalid_argument for other rods and amounts.
std::vector<Tip> tips_under_moment(const Rod& rod, const Vec3<double>& direction,
                                   const std::vector<double>& amounts);

/// The rotation of the tip of a straight uniform rod under a fixed end moment, to all orders: the angular law
/// of a joint that stands for the whole rod.
/// @param stiffness  of that joint at zero, (GJ, EI2, EI3)/length in any axes: symmetric, positive definite,
///                   N m/rad. @param moment  N m
/// @return  R_b, axes of the tip -> axes of the clamp. Throws std::invalid_argument for another stiffness.
Mat3<double> end_rotation(const Mat3<double>& stiffness, const Vec3<double>& moment);

/// Equilibrium under any loads on the branch that grows from none, by shooting: Newton on n and m at the
/// clamp, with the variational equations, along the load in steps that halve where it fails. Throws
/// std::runtime_error that says up to which share of the loads it came.
Tip solve(const Rod& rod, const Loads& loads);

/// The same by Chebyshev collocation of degree `degree` (>= 8) in the integral form of the equations, a road
/// that shares the equations above and nothing else with solve(). `error` is by `degree` - 4.
/// Throws std::runtime_error as solve() does.
Tip collocate(const Rod& rod, const Loads& loads, int degree);

}  // namespace halfway::reference::rod
