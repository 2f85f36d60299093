// Wrong chains: each must be seen by the measurement that the studies make.
#include "verify/oracle/mutants/verdicts.hpp"
#include "verify/studies/chains/chain_rods.hpp"

#include <cmath>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;

constexpr long kMutantLinks = 256;

chain::Chain invariant_chain(const ChainRod& rod) {
  return chain_with(*rod.scene, *reference::find_formulation("invariant"), kMutantLinks);
}

/// How far the error of the tip is from the kept constant of second order, over that.
Measurement off_constant(const ChainRod& rod, const Vec3<double>& tip) {
  constexpr double kConstant = 0.2102;  // invariant, straight_anisotropic
  const double error = (tip - rod.tip).norm() / rod.scene->chain.length;
  return {std::abs(error * double(kMutantLinks * kMutantLinks) / kConstant - 1), rod.scene->name};
}

Vec3<double> tip_of(const chain::Chain& c, const chain::EndLoads& loads) {
  const chain::Solution found = chain::solve(c, loads);
  return found.converged ? chain::pose(found.nodes.back()).x : Vec3<double>::Constant(std::nan(""));
}

/// Joints at the ends of their links: those at the middles, half a link further on, the force on the last
/// joint, half a link before the last node, with the moment that it has about that.
Vec3<double> tip_with_joints_at_ends(const ChainRod& rod) {
  const chain::Chain c = invariant_chain(rod);
  const double half = c.length / double(c.links) / 2;
  const Vec3<double> back = -half * Vec3<double>::UnitX();
  chain::EndLoads loads = rod.loads;
  chain::Solution found;
  for (int i = 0; i < 8;
       ++i) {  // the moment turns with the node: each time a hundredth of its change is left
    found = chain::solve(c, loads);
    loads.moment = rod.loads.moment + (chain::pose(found.nodes.back()).R * back).cross(rod.loads.force);
  }
  const Pose<double> last = chain::pose(found.nodes.back());
  return last.x + last.R * back + half * c.root.R.col(0);
}

/// The rod's length is that of its links, half a link too many at each end.
Vec3<double> tip_of_longer_chain(const ChainRod& rod) {
  chain::Chain c = invariant_chain(rod);
  c.length *= 1 + 1. / double(c.links);
  return tip_of(c, rod.loads);
}

/// The loads of the scene turned with the node.
Vec3<double> tip_with_followers(const ChainRod& rod) {
  chain::EndLoads loads;
  loads.follower_force = rod.loads.force;
  loads.follower_moment = rod.loads.moment;
  return tip_of(invariant_chain(rod), loads);
}

void add(Checks& checks, const char* name, Vec3<double> (*mutant)(const ChainRod&)) {
  add_mutant(checks, name, "chains/invariant/constant", 0.02, [mutant] {
    const ChainRod& rod = chain_rod("straight_anisotropic");
    return std::pair{off_constant(rod, mutant(rod)),
                     off_constant(rod, tip_of(invariant_chain(rod), rod.loads))};
  });
}

}  // namespace

void chain_mutants(Checks& checks) {
  add(checks, "chain_joints_at_ends", tip_with_joints_at_ends);
  add(checks, "chain_half_a_link_too_long", tip_of_longer_chain);
  add(checks, "chain_loads_follow", tip_with_followers);
}

}  // namespace halfway::verify
