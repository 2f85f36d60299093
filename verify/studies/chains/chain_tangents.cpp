#include "verify/studies/chains/chain_tangents.hpp"

#include "verify/check.hpp"
#include "verify/once.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_orders.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;
using reference::Entry;

constexpr std::pair<const char*, chain::Tangent> kTangents[] = {
    {"exact", chain::Tangent::exact},
    {"symmetrised", chain::Tangent::symmetrised},
    {"attached", chain::Tangent::attached},
    {"frozen_each_step", chain::Tangent::frozen_step},
    {"frozen_at_first", chain::Tangent::frozen_first}};

constexpr const char* kTangentRod = "straight_anisotropic";

TangentCost cost_of(const Entry& entry, const char* name, chain::Settings settings) {
  const ChainRod& rod = chain_rod(kTangentRod);
  settings.most_iterations = 100;
  const double start = thread_seconds();
  const chain::Solution found = chain::solve(chain_with(*rod.scene, entry, 64), rod.loads, settings);
  return {name,
          found.converged,
          tapped(int(found.iterations.size())),
          settings.load_steps,
          thread_seconds() - start,
          tapped(Vec3<double>(chain::pose(found.nodes.back()).x))};
}

TangentCost cheapest(const Entry& entry, const char* name, chain::Tangent tangent) {
  TangentCost out;
  for (int steps = 1; steps <= 256 && !out.converged; steps *= 4) {
    chain::Settings settings;
    settings.tangent = tangent;
    settings.load_steps = steps;
    out = cost_of(entry, name, settings);
  }
  return out;
}

std::string told(const TangentCost& cost) {
  return fmt::format("{} iterations in {} load steps, {:.2g} ms", cost.iterations, cost.load_steps,
                     1e3 * cost.seconds);
}

Draft draft_of(const Entry& entry, const std::string& what) {
  return finding(fmt::format("chains/{}/tangent/{}", entry.name, what))
      .about("chains")
      .of(std::string(entry.name), "linear_angular");
}

std::vector<Finding> costs(const Entry& entry) {
  const auto& all = tangent_costs(entry);
  const TangentCost& exact = all.front();
  std::vector<Finding> out;
  out.push_back(
      draft_of(entry, "exact_iterations")
          .measured(exact.converged ? exact.iterations : std::nan(""), told(exact))
          .in("iterations")
          .at_most(9,
                   "quadratic from rest to 1e-12: 7 where the angles of the law are small; all load in "
                   "one step, kept of an independent prototype")
          .by(Oracle::independent));
  for (std::size_t i = 1; i < all.size(); ++i) {
    const TangentCost& cost = all[i];
    const std::string name = cost.name;
    if (!cost.converged) {
      out.push_back(
          draft_of(entry, name).measured(cost.iterations, told(cost)).reported("it does not arrive"));
      continue;
    }
    out.push_back(draft_of(entry, name + "/tip")
                      .measured((cost.tip - exact.tip).norm(), told(cost))
                      .in("m")
                      .at_most(1e-9, "the same equilibrium: increments of a linear convergence stop at 1e-9")
                      .by(Oracle::independent));
    out.push_back(draft_of(entry, name)
                      .measured(double(cost.iterations) / exact.iterations, told(cost))
                      .in("of the exact tangent's iterations")
                      .reported("what a wrong tangent costs"));
  }
  return out;
}

}  // namespace

const std::vector<TangentCost>& tangent_costs(const Entry& entry) {
  static Once<std::vector<TangentCost>, Tap> kept;
  return kept(entry, passing(), [&] {
    std::vector<TangentCost> out;
    for (const auto& [name, tangent] : kTangents) out.push_back(cheapest(entry, name, tangent));
    return out;
  });
}

void chain_tangents(Checks& checks) {
  for (const Entry* entry : chain_formulations()) {
    checks.push_back(
        {fmt::format("chains/{}/tangents", entry->name), "chains", [entry] { return costs(*entry); }});
  }
}

}  // namespace halfway::verify
