// How long do statics of a chain take: a Newton iteration a joint, and whole solutions?
#include "bench/harness/case.hpp"
#include "reference/chain/chain.hpp"
#include "reference/chain/iteration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>

namespace halfway::bench {

Cases chain_cases();

namespace {

using batch::Isa;
using reference::chain::Chain, reference::chain::EndLoads, reference::chain::Section,
    reference::chain::Settings;

/// A rod and the place of its tip by another road.
struct Rod {
  const char* name;
  Chain chain;
  EndLoads loads;
  Vec3<double> tip;
};

/// A chain's own error of the tip, over L: constant / N^order to leading order.
struct Law {
  const char* formulation;
  double constant;
  int order = 2;
};

/// Bent and twisted at rest, of anisotropic sections; tip by shooting (80-bit Taylor series).
Rod precurved() {
  Rod rod{"precurved", {}, {}, {.788129270955297, .252875294051301, .442694988997110}};
  rod.chain.section = {.8, 1, 4, 1e4, 5e3, 5e3};
  rod.chain.curvature = {3, .5, .2};
  rod.loads.force = {-.5, 1, 2}, rod.loads.moment = {.5, -.5, .3};
  return rod;
}

/// Rolled to a half circle by a moment: N equal turns of pi/N about the joints.
Rod half_circle() {
  Rod rod{"half_circle", {}, {}, {0, 2 / std::numbers::pi, 0}};
  rod.chain.section = {1, 1, 1, 3e4, 3e4, 3e4};
  rod.loads.moment = {0, 0, std::numbers::pi};
  return rod;
}

/// The 45 degree bend (Bathe and Bolourchi 1979) under 600, torsion constant of a square by Saint-Venant, tip
/// and constant by shooting (80-bit Taylor series).
Rod bend() {
  Rod rod{"bend_45", {}, {}, {15.55778591410, 46.89192495315, 53.60736917666}};
  const double EI = 1e7 / 12;
  rod.chain.length = 25 * std::numbers::pi;
  rod.chain.section = {5e6 * .140577014955, EI, EI, 1e7, 5e6, 5e6};
  rod.chain.curvature = {0, 0, .01};
  rod.chain.root.R << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  rod.loads.force = {0, 0, 600};
  return rod;
}

/// Laws of the precurved rod, from a prototype that shares nothing with this code (banded LU of the whole
/// matrix): three digits and more.
constexpr Law kPrecurved[] = {
    {"invariant", .4620}, {"attached_a", .242, 1}, {"fasse", .358}, {"potential", .4649}};
/// The chord of a polygon of N sides is h / sin(pi/2N), of the half circle 2 L/pi.
constexpr Law kHalfCircle{"invariant", std::numbers::pi / 6};
constexpr Law kBend{"invariant", .2581};

/// What of the tip's error the law leaves, over L, at most 2 % of it: the constant's last digit and the next
/// order. With more links than 1e4 rounding is as large as that.
Checked check(const Rod& rod, const Law& law, long links, Isa isa) {
  Chain chain = rod.chain;
  chain.formulation = law.formulation, chain.links = std::min(links, 10000L);
  Settings settings;
  settings.isa = isa;
  const auto solution = reference::chain::solve(chain, rod.loads, settings);
  if (!solution.converged) return {.message = solution.outcome};
  const double miss = (pose(solution.nodes.back()).x - rod.tip).norm() / chain.length;
  const double expected = law.constant / std::pow(double(chain.links), law.order);
  Checked out{.error = std::abs(miss - expected)};
  if (!(out.error <= .02 * expected))
    out.message = fmt::format("the tip is {:.3e} L off, wanted {:.3e} L", miss, expected);
  return out;
}

Case labelled(const Rod& rod, const char* what, const std::string& formulation, Isa isa, long links) {
  Case c;
  c.formulation = formulation;
  c.kind = "linear_angular";
  c.what = what;
  c.implementation = "chain";
  c.variant = rod.name;
  c.isa = batch::to_string(isa);
  c.joints = int(links), c.threads = 1;
  c.name = fmt::format("{}/{}/{}/{}/{}", formulation, what, rod.name, c.isa, links);
  return c;
}

/// One Newton iteration, of `links` evaluations: the increments of the chain at rest.
Case iteration(const Law& law, Isa isa, long links) {
  const Rod rod = precurved();
  Case c = labelled(rod, "chain_iteration", law.formulation, isa, links);
  c.evaluations = int(links);
  c.check = [=] { return check(rod, law, links, isa); };
  Chain chain = rod.chain;
  chain.formulation = law.formulation, chain.links = links;
  using reference::chain::Iterating;
  c.timed = [=](benchmark::State& state) {
    Iterating one(chain, isa);
    for (auto _ : state) one.run();
  };
  c.evaluate = [=, one = std::shared_ptr<Iterating>()](int iterations) mutable {
    if (!one) one = std::make_shared<Iterating>(chain, isa);
    for (int i = 0; i < iterations; ++i) one->run();
  };
  return c;
}

/// From the chain at rest to all nodes.
Case solution(const Rod& rod, const Law& law, long links) {
  const Isa isa = batch::choose({});
  Case c = labelled(rod, "chain_solution", law.formulation, isa, links);
  c.check = [=] { return check(rod, law, links, isa); };
  Rod timed = rod;
  timed.chain.links = links;
  time_by(c, [timed](int iterations) {
    for (int i = 0; i < iterations; ++i) {
      auto nodes = reference::chain::solve(timed.chain, timed.loads).nodes;
      benchmark::DoNotOptimize(nodes);
    }
  });
  return c;
}

}  // namespace

/// With a million links where HALFWAY_LARGE is set: 0.6 GB and some seconds.
Cases chain_cases() {
  Cases cases;
  const Isa widest = batch::choose({});
  const Law& invariant = kPrecurved[0];
  for (const long links : {1000L, 100000L}) cases.push_back(iteration(invariant, widest, links));
  for (const Law& law : kPrecurved) cases.push_back(iteration(law, widest, 10000));
  for (const Isa isa : {Isa::sse2, Isa::avx2}) {
    if (isa != widest && batch::available(isa)) cases.push_back(iteration(invariant, isa, 10000));
  }
  cases.push_back(solution(half_circle(), kHalfCircle, 100000));
  cases.push_back(solution(bend(), kBend, 100000));
  if (std::getenv("HALFWAY_LARGE") != nullptr) {
    cases.push_back(iteration(invariant, widest, 1000000));
    cases.push_back(solution(bend(), kBend, 1000000));
  }
  return cases;
}

}  // namespace halfway::bench
