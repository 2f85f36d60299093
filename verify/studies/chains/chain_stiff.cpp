// Chains of rod34, whose law sees a rod's strains, from soft rods to those that hardly stretch: they are
// solved in one load step, and tend to the rod with N^-4.
#include "reference/truth/rod/rod.hpp"
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_rods.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;
namespace rod = reference::rod;
using reference::Measurement;

constexpr const char* kName = "rod34";

Draft draft_of(const std::string& what) {
  return finding(fmt::format("chains/{}/{}", kName, what)).about("chains").of(kName, "linear_angular");
}

/// The chain of a scene whose EA is `ratio` times EI2/L^2, GA as much of it as in the scene.
chain::Chain with_stiffness(const reference::ChainScene& scene, double ratio, long links) {
  chain::Chain out = chain_with(scene, *reference::find_formulation(kName), links);
  const double scale = ratio * out.section.EI2 / (out.length * out.length * out.section.EA);
  out.section.EA *= scale, out.section.GA2 *= scale, out.section.GA3 *= scale;
  return out;
}

constexpr double kRatios[] = {1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
constexpr long kLinks[] = {4, 16, 64, 256, 1000};

/// The chains of one scene, each solved at once from rest.
struct Range {
  Measurement miss, iterations;  ///< NaN where one is not solved

  void include(const ChainRod& rod, const Vec3<double>& wanted, double ratio, long links) {
    const chain::Chain c = with_stiffness(*rod.scene, ratio, links);
    const chain::Solution found = chain::solve(c, rod.loads);
    const double solved = found.converged ? 1 : std::nan("");
    const auto at = fmt::format("EA L^2/EI = {:.0e}, {} links: {}", ratio, links, found.outcome);
    const Vec3<double> tip = tapped(Vec3<double>(solved * chain::pose(found.nodes.back()).x));
    const double left = 0.3 / double(links * links) + 10 / kRatios[0];
    miss.include((tip - wanted).norm() / c.length / left, at);
    iterations.include(solved * double(found.iterations.size()), at);
  }
};

std::vector<Finding> solved(const char* name, const Vec3<double>& tip) {
  const ChainRod& rod = chain_rod(name);
  Range range;
  for (const double ratio : kRatios) {
    for (const long links : kLinks) range.include(rod, tip, ratio, links);
  }
  for (const double ratio : {kRatios[0], kRatios[5]}) range.include(rod, tip, ratio, by_effort(10000, 2000));
  return {draft_of(fmt::format("solved/{}", name))
              .measured(range.miss)
              .in("of 0.3 L/N^2 + 1e-3 L")
              .at_most(
                  1,
                  "where the rod is: chains of second order are up to 0.26 L/N^2 off there, and forces below "
                  "10 EI/L^2 stretch a rod of another EA by 1e-3")
              .by(Oracle::independent, rod.uncertainty),
          draft_of(fmt::format("iterations/{}", name))
              .measured(range.iterations)
              .at_most(
                  12,
                  "Newton's: laws of d take up to 10, and the stiffest of the longest chains some more among "
                  "rounding")
              .by(Oracle::independent)};
}

struct Stiffness {
  const char* name;
  double EA, GA;
};

/// Larger of the tip's misses: of position over L, and of rotation.
double miss(const chain::Chain& c, const chain::EndLoads& loads, const rod::Tip& tip) {
  const chain::Solution found = chain::solve(c, loads);
  if (!found.converged) return std::nan("");
  const Pose<double> last = chain::pose(found.nodes.back());
  const double turn = so3::log<double>(last.R.transpose() * tip.R).norm();
  return tapped(reference::larger((last.x - tip.x).norm() / c.length, turn));
}

/// Of the last doubling, under loads of which half follow the tip.
Finding order(const Stiffness& s, double wanted, double tolerance, const char* why) {
  const reference::ChainScene& scene = chain_scene("straight_anisotropic");
  chain::Chain c = chain_with(scene, *reference::find_formulation(kName), 32);
  c.section.EA = s.EA, c.section.GA2 = c.section.GA3 = s.GA;
  const chain::EndLoads loads{{-.5, 1, 2}, {.3, -.7, .4}, {.5, -.5, .3}, {.1, .3, -.2}};
  const chain::Section& k = c.section;
  const rod::Tip tip =
      rod::collocate(rod::straight(c.length, rod::of_stiffness({k.GJ, k.EI2, k.EI3}, {k.EA, k.GA2, k.GA3})),
                     {loads.force, loads.moment, loads.follower_force, loads.follower_moment}, 40);
  const double coarse = miss(c, loads, tip);
  c.links *= 2;
  const double fine = miss(c, loads, tip);
  return draft_of(fmt::format("order_by_stiffness/{}", s.name))
      .measured(std::log2(coarse / fine), fmt::format("{:.2e} with 32 links, {:.2e} with 64", coarse, fine))
      .equal(wanted, tolerance, why)
      .by(Oracle::independent, tip.error / fine / std::log(2.));
}

std::vector<Finding> orders() {
  constexpr const char* kFour =
      "a law of fourth order; 64 links leave less than 0.1 of the next one, h^2 higher";
  constexpr const char* kTwo =
      "x' = R C R^T n: where 1/EA is not 1/GA its mean over a link that turns is of second order, which no "
      "term "
      "of the law has: that of 1/GA - 1/EA is left";
  return {order({"soft", 1e4, 1e4}, 4, 0.1, kFour), order({"stiff", 1e6, 1e6}, 4, 0.1, kFour),
          order({"stiffest", 1e8, 1e8}, 4, 0.1, kFour), order({"unlike_in_shear", 1e2, 50}, 2, 0.1, kTwo)};
}

}  // namespace

void chain_stiff(Checks& checks) {
  for (const char* name : {"straight_anisotropic", "bend_45_st_venant"}) {
    checks.push_back({fmt::format("chains/rod34/solved/{}", name), "chains",
                      [name] { return solved(name, chain_rod(name).tip); }});
  }
  checks.push_back(
      {"chains/rod34/solved/roll_up", "chains", [] { return solved("roll_up", Vec3<double>::Zero()); }});
  checks.push_back({"chains/rod34/order_by_stiffness", "chains", orders});
}

}  // namespace halfway::verify
