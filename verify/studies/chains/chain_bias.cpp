// Which node of a joint is its node a: nothing where the law is half-way, else the error changes sign with
// it.
#include "verify/check.hpp"
#include "verify/once.hpp"
#include "verify/oracle/saboteurs/tap.hpp"
#include "verify/studies/chains/chain_orders.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

using reference::Entry;

const ChainOrder& exchanged(const Entry& entry, const std::string& rod) {
  static Once<ChainOrder, Tap, std::string> kept;
  return kept(entry, passing(), rod,
              [&] { return orders_of(entry, chain_rod(rod), reference::chain::NodeOrder::tip_first); });
}

/// (m + sign m')/2 of the misses in both node orders.
ChainOrder combined(const Entry& entry, const std::string& rod, double sign) {
  ChainOrder out = chain_order(entry, rod);
  const ChainOrder& other = exchanged(entry, rod);
  for (std::size_t i = 0; i < out.points.size(); ++i)
    out.points[i].miss = (out.points[i].miss + sign * other.points[i].miss) / 2;
  fit_order(chain_rod(rod), out);
  return out;
}

Draft draft_of(const Entry& entry, const char* what, const std::string& rod) {
  return finding(fmt::format("chains/{}/{}/{}", entry.name, what, rod))
      .about("chains")
      .of(std::string(entry.name), "linear_angular");
}

Finding same_tip(const Entry& entry, const std::string& rod) {
  const ChainPoint difference = combined(entry, rod, -1).points.back();
  return draft_of(entry, "node_order", rod)
      .measured(difference.error())
      .in("L")
      .at_most(1e-13, "no half of a joint is told from the other: rounding of 256 positions, some eps each")
      .by(Oracle::closed_form);
}

/// Exchanging the nodes turns the rod round: odd powers of h change sign, even ones do not.
std::vector<Finding> opposite(const Entry& entry, const std::string& rod) {
  const ChainOrder odd = combined(entry, rod, -1), even = combined(entry, rod, 1);
  constexpr const char* kWhy =
      "by symmetry the errors of both node orders differ in odd powers of h and agree in even "
      "ones; the next of them leaves less than 0.03 from 64 links on";
  return {draft_of(entry, "bias", rod)
              .measured(odd.order,
                        fmt::format("{:.4f} +- {:.1g}; half of the difference is {:.3g} L at 256 links",
                                    odd.order, odd.order_bar, odd.points.back().error()))
              .equal(1, 0.03, kWhy)
              .by(Oracle::closed_form, odd.order_bar),
          draft_of(entry, "mean_of_node_orders", rod)
              .measured(even.order, fmt::format("{:.4f} +- {:.1g}; the mean is {:.3g} L off at 256 links",
                                                even.order, even.order_bar, even.points.back().error()))
              .equal(2, 0.03, kWhy)
              .by(Oracle::closed_form, even.order_bar)};
}

std::vector<Finding> node_orders(const Entry& entry) {
  std::vector<Finding> out;
  for (const char* rod : kOrderRods) {
    if (entry.facts.node_order.linear_angular.holds()) {
      out.push_back(same_tip(entry, rod));
    } else if (kept_limit(entry, rod)) {
      out.push_back(draft_of(entry, "bias", rod).left_out("its chains tend to another rod"));
    } else if (expected_order(entry) == 2) {
      const ChainOrder odd = combined(entry, rod, -1);
      out.push_back(draft_of(entry, "bias", rod)
                        .measured(odd.order)
                        .reported("second order in both node orders: what differs has no target"));
    } else {
      for (const Finding& f : opposite(entry, rod)) out.push_back(f);
    }
  }
  return out;
}

}  // namespace

void chain_bias(Checks& checks) {
  for (const Entry* entry : chain_formulations()) {
    checks.push_back({fmt::format("chains/{}/node_order", entry->name), "chains",
                      [entry] { return node_orders(*entry); }});
  }
}

}  // namespace halfway::verify
