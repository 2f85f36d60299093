#include "reports/views/rods/chains.hpp"

#include "reports/views/rounded.hpp"
#include "verify/studies/chains/chain_orders.hpp"
#include "verify/studies/chains/chain_tangents.hpp"

namespace halfway::reports {
namespace {

using namespace verify;
using nlohmann::json;
using reference::Entry;

json order_row(const Entry& entry, const char* rod) {
  const ChainOrder& of = chain_order(entry, rod);
  json points = json::array();
  for (const ChainPoint& p : of.points)
    points.push_back({{"links", p.links},
                      {"error", rounded(p.error(), 4)},
                      {"iterations", p.iterations},
                      {"ms", rounded(1e3 * p.seconds, 4)}});
  return {{"formulation", entry.name},
          {"rod", rod},
          {"order", rounded(of.order, 4)},
          {"order_bar", rounded(of.order_bar, 4)},
          {"points", points}};
}

json tangent_row(const Entry& entry) {
  json costs = json::array();
  for (const TangentCost& c : tangent_costs(entry))
    costs.push_back({{"tangent", c.name},
                     {"converged", c.converged},
                     {"iterations", c.iterations},
                     {"load_steps", c.load_steps},
                     {"ms", rounded(1e3 * c.seconds, 4)}});
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
