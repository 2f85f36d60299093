#include "reports/identify/results.hpp"

#include <cmath>

namespace halfway::reports {

namespace id = reference::identify;

std::array<double, id::kChannels> channel_errors(const id::Data& data, const id::Fit& fit) {
  std::array<double, id::kChannels> sum{}, count{};
  const std::vector<int> channel = id::channels(data);
  for (std::size_t i = 0; i < channel.size(); ++i) {
    sum[std::size_t(channel[i])] += fit.residual[Eigen::Index(i)] * fit.residual[Eigen::Index(i)];
    count[std::size_t(channel[i])] += 1;
  }
  for (std::size_t c = 0; c < id::kChannels; ++c) sum[c] = std::sqrt(sum[c] / count[c]);
  return sum;
}

namespace {

/// Conservative, the same whichever body is called a, and for any rotation below half a turn.
bool is_sound(const id::CatalogFit& one, Kind kind) {
  const auto* entry = reference::find_formulation(one.name);
  return one.is_conservative && entry->facts.node_order.of(kind).holds() && !entry->convex_radius;
}

}  // namespace

BestJoint best_joint(const Identified& what) {
  const id::Identification& found = what.found;
  if (found.best < 0) {
    const id::Fit& fit = found.chosen_stage().fit;  // of a linear joint: no formulation is asked
    return {"invariant", found.values(fit), fit, 0.5};
  }
  const id::CatalogFit* best = &found.catalog[std::size_t(found.best)];
  for (const id::CatalogFit& one : found.catalog) {  // best first
    if (!one.left_out.empty() || one.probability < id::kRejected || !is_sound(one, what.data.kind)) continue;
    best = &one;
    break;
  }
  const id::JointValues values = found.values(best->fit);
  return {best->name, values, best->fit, values.xi_angular[0]};
}

}  // namespace halfway::reports
