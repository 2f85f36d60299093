#include "reports/views/rods/chains.hpp"

#include "reports/views/rounded.hpp"
#include "verify/studies/chains/chain_orders.hpp"
#include "verify/studies/chains/chain_tangents.hpp"

#include <cmath>

namespace halfway::reports {
namespace {

using namespace verify;
using nlohmann::json;
using reference::Entry;

json number(double x) { return std::isfinite(x) ? json(rounded(x, 4)) : json(); }

json order_row(const Entry& entry, const char* rod) {
  const ChainOrder& of = chain_order(entry, rod);
  json points = json::array();
  for (const ChainPoint& p : of.points)
    points.push_back({{"links", p.links},
                      {"error", number(p.error())},
                      {"iterations", p.iterations},
                      {"ms", number(1e3 * p.seconds)}});
  return {{"formulation", entry.name},
          {"rod", rod},
          {"order", number(of.order)},
          {"order_bar", number(of.order_bar)},
          {"points", points}};
}

json tangent_row(const Entry& entry) {
  json costs = json::array();
  for (const TangentCost& c : tangent_costs(entry))
    costs.push_back({{"tangent", c.name},
                     {"converged", c.converged},
                     {"iterations", c.iterations},
                     {"load_steps", c.load_steps},
                     {"ms", number(1e3 * c.seconds)}});
  return {{"formulation", entry.name}, {"costs", costs}};
}

}  // namespace

json chains_record() {
  json orders = json::array(), tangents = json::array();
  for (const char* rod : kOrderRods)
    for (const Entry* entry : chain_formulations()) orders.push_back(order_row(*entry, rod));
  for (const Entry* entry : chain_formulations()) tangents.push_back(tangent_row(*entry));
  return {{"orders", orders}, {"tangents", tangents}};
}

}  // namespace halfway::reports
