// Chains of many links: what rounding leaves of the answer, and of the order.
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_rods.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;

chain::Solution invariant_chain(const ChainRod& rod, long links) {
  return chain::solve(chain_with(*rod.scene, *reference::find_formulation("invariant"), links), rod.loads);
}

std::string iterations_of(const chain::Solution& s) {
  return fmt::format("{} iterations, {} load steps: {}", s.iterations.size(), s.load_steps, s.outcome);
}

/// The last node back on the first, from a straight start.
std::vector<Finding> roll_up() {
  const long links = by_effort(100000, 10000);
  const reference::ChainScene& scene = chain_scene("roll_up");
  const chain::Solution found =
      chain::solve(chain_with(scene, *reference::find_formulation("invariant"), links), scene.loads);
  Draft f = finding("chains/many_links/roll_up").about("chains").of("invariant", "linear_angular");
  f.measured(found.converged ? tapped(chain::pose(found.nodes.back()).x.norm()) : std::nan(""),
             fmt::format("{} links, {}", links, iterations_of(found)));
  return {f.in("m")
              .at_most(1e-11 * scene.chain.length,
                       "a regular polygon closes; 1e5 positions of some eps each, stiffnesses 1e4 apart")
              .by(Oracle::closed_form)};
}

/// Error N^2 over L of a bend: the constant of the order, 1e4 links away from where the order was measured.
Finding bend(const std::string& name, double kept) {
  constexpr double kLinks = 1e4;
  const ChainRod& rod = chain_rod(name);
  const chain::Solution found = invariant_chain(rod, long(kLinks));
  const double square = kLinks * kLinks / rod.scene->chain.length;
  Draft f = finding("chains/many_links/" + name).about("chains").of("invariant", "linear_angular");
  if (found.converged) {
    const Vec3<double> tip = chain::pose(found.nodes.back()).x;
    f.measured(square * tapped(Vec3<double>(tip - rod.tip)).norm(), iterations_of(found));
  }
  return f.in("L/N^2")
      .equal(kept, 5e-4,
             "kept of an independent prototype, to four digits the same at 1e3 and 1e4 links; rounding of "
             "1e-15 L and "
             "the digits of the rod make 2e-4 of it")
      .by(Oracle::independent, square * rod.uncertainty);
}

std::vector<Finding> bends() { return {bend("bend_45_polar", 0.2575), bend("bend_45_st_venant", 0.2581)}; }

}  // namespace

void chain_many_links(Checks& checks) {
  checks.push_back({"chains/many_links/roll_up", "chains", roll_up});
  checks.push_back({"chains/many_links/bend_45", "chains", bends});
}

}  // namespace halfway::verify
