// One joint in place of a slender rod: how far it is from the rod, and how far it goes.
//
// A rod under an end moment is an angular joint of stiffness (GJ, EI2, EI3)/L; under an end force, a joint at
// mid-length. What the rod does is known to ten digits and more, so that laws which agree at small rotations
// can be told apart.
#pragma once

#include "reference/face/registry.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace halfway::verify {

/// Of one formulation along a rising load: error[i] = |theta_joint - theta_rod| / |theta_rod|, NaN from where
/// the joint has no equilibrium that the solver reaches.
struct Followed {
  std::vector<double> error;
  /// Which load is the last up to which the error stays within a tolerance; nothing where it does nowhere.
  std::optional<std::size_t> last_within(double tolerance) const;
};

/// The slender rod that has the stiffness of C3's block, under its fixed moment of skew direction.
struct SkewMoment {
  std::vector<double> moment;     ///< N m
  std::vector<double> rod_angle;  ///< |theta|, rad
  std::vector<Vec3<double>> rod;  ///< theta, rad
};
const SkewMoment& skew_moment();
const Followed& follows_skew_moment(const reference::Entry& entry);

/// What is random: the direction of the moment, so that most of the turn is about the softest axis; or that
/// of the turn K^-1 m, which takes all axes alike and large moments about the stiff ones.
enum class Drawn { moment, turn };
const char* to_string(Drawn drawn);

/// Random fixed moments of one size on a rod of one stiffness.
struct RandomMoments {
  const char* name;
  Vec3<double> stiffness;  ///< GJ/L, EI2/L, EI3/L, N m/rad
  Drawn drawn;
  double size;  ///< |K^-1 m|, rad
};
const std::vector<RandomMoments>& random_moments();

/// Turn between the loaded ends of joint and rod over the rod's own turn.
struct Spread {
  double median = 0;  ///< NaN where half of the joints or more have no equilibrium there
  int lost = 0;       ///< of `of`, that have none
  int of = 0;
};
const Spread& error_of_random(const reference::Entry& entry, const RandomMoments& moments);

/// Critical semi-tangential moment about the rod's axis of the rod, and of one joint.
struct SemiTangential {
  const char* name;
  Vec3<double> stiffness;  ///< N m/rad
  double critical;         ///< of the rod, N m
};
const std::vector<SemiTangential>& semi_tangential();
/// N m; nothing where the joint has none below half a turn.
const std::optional<double>& critical_of(const reference::Entry& entry, const SemiTangential& rod);

}  // namespace halfway::verify
