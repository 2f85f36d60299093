#include "verify/studies/chains/chain_orders.hpp"

#include "halfway/batch/batch.hpp"
#include "reference/chain/scenes/solve_chain_scene.hpp"
#include "reference/truth/data.hpp"
#include "verify/once.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <cmath>
#include <ctime>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;

ChainPoint point_of(const reference::Entry& entry, const ChainRod& rod, chain::NodeOrder order, long links) {
  chain::Chain asked = chain_with(*rod.scene, entry, links);
  asked.node_order = order;
  const double start = thread_seconds();
  const chain::Solution found = chain::solve(asked, rod.loads);
  ChainPoint out{links};
  out.iterations = int(found.iterations.size());
  out.seconds = thread_seconds() - start;
  if (found.converged && reference::beyond_series(entry, asked, found.nodes).empty())
    out.miss = tapped((chain::pose(found.nodes.back()).x - rod.tip) / asked.length);
  return out;
}

}  // namespace

double thread_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

std::optional<double> kept_limit(const reference::Entry& entry, const std::string& rod) {
  static const nlohmann::json table = reference::read_data("chains/orders.json")["limits"];
  for (const auto& row : table) {
    if (row["formulation"] == entry.name && row["rod"] == rod) return row["limit"].get<double>();
  }
  return std::nullopt;
}

double expected_order(const reference::Entry& entry) {
  const double frame = entry.needs_xi ? entry.probe_xi : entry.facts.alpha;
  return entry.facts.has_fingerprint && frame == 0.5 && entry.facts.beta == 0 ? 2 : 1;
}

std::vector<const reference::Entry*> chain_formulations() {
  std::vector<const reference::Entry*> out;
  for (const auto& entry : reference::formulations()) {
    if (batch::Batch::knows(entry.name)) out.push_back(&entry);
  }
  return out;
}

void fit_order(const ChainRod& rod, ChainOrder& out) {
  const auto error = [&](std::size_t back) { return out.points.at(out.points.size() - back).error(); };
  const double before = std::log2(error(3) / error(2));
  out.order = std::log2(error(2) / error(1));
  const double open = rod.uncertainty / rod.scene->chain.length / (error(1) * std::log(2.));
  out.order_bar = std::abs(out.order - before) + open;
}

ChainOrder orders_of(const reference::Entry& entry, const ChainRod& rod, chain::NodeOrder order) {
  ChainOrder out;
  for (long links = 8; links <= 256; links *= 2) out.points.push_back(point_of(entry, rod, order, links));
  fit_order(rod, out);
  return out;
}

const ChainOrder& chain_order(const reference::Entry& entry, const std::string& rod) {
  static Once<ChainOrder, Tap, std::string> kept;
  return kept(entry, passing(), rod,
              [&] { return orders_of(entry, chain_rod(rod), chain::NodeOrder::root_first); });
}

}  // namespace halfway::verify
