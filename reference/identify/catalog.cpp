#include "reference/identify/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference::identify {
namespace {

bool is_coupling(int place) { return place >= kCoupling && place < kJointPoint; }

/// Of the stiffness alone.
Freedom without_second_order(Freedom freedom) {
  std::erase_if(freedom.active, [](int place) { return place >= kXiAngular && place <= kCubic; });
  for (int i = 0; i < kPlaces; ++i) freedom.source[std::size_t(i)] = i;
  return freedom;
}

double largest_turn(const Data& data) {
  double out = 0;
  for (const LoadCase& one : data.cases) {
    for (const Vec6& z : one.motions) out = std::max(out, z.tail<3>().norm());
  }
  return out;
}

std::string why_not(const Entry& entry, const Data& data, const Identification& found) {
  if (entry.needs_length) return "takes the length of a rod, which the data do not say";
  if (!entry.convex_radius || data.kind == Kind::linear) return "";
  const JointSpec spec = joint_spec(found.frame, found.values(found.chosen_stage().fit));
  const auto* law = std::get_if<LinearSpec>(&spec.law);
  if (!law) return "is a series of one stiffness: takes no curves";
  const double radius = entry.convex_radius(law->matrix), turn = largest_turn(data);
  if (turn <= radius) return "";
  return fmt::format("refuses beyond {:.3g} rad for this stiffness; the data turn by {:.3g}", radius, turn);
}

CatalogFit fit_one(const Entry& entry, const Data& data, const Identification& found) {
  CatalogFit out;
  out.name = entry.name;
  out.is_conservative = entry.has_potential(data.kind);
  out.left_out = why_not(entry, data, found);
  if (!out.left_out.empty()) return out;
  const StageFit& chosen = found.chosen_stage();
  const StageFit& from = chosen.stage == Stage::axis_laws ? chosen : found.stage(Stage::half_way);
  Freedom freedom = without_second_order(from.fit.freedom);
  Unknowns start = from.fit.p;
  start.segment<6>(kXiAngular).setConstant(0.5);
  start[kCubic] = 0;
  const StageFit& one_xi = found.stage(Stage::one_xi);
  if (entry.needs_xi && one_xi.fit.is_active(kXiAngular)) {
    freedom.active.push_back(kXiAngular);
    start[kXiAngular] = one_xi.fit.p[kXiAngular];
  }
  if (entry.block_diagonal_law_only) {
    std::erase_if(freedom.active, is_coupling);
    start.segment<6>(kCoupling).setZero();
  }
  const Frame frame = found.frame;
  const MakeModel make = [&entry, frame](const Unknowns& p) {
    return catalog_model(entry, frame, values_of(frame, p));
  };
  out.fit = fit(data, make, start, freedom, found.sigma);
  if (!out.fit.converged) out.left_out = "no fit: " + out.fit.reason;
  return out;
}

}  // namespace

void fit_catalog(const Data& data, Identification& out) {
  if (data.kind == Kind::linear) return;  // without rotation they are one
  // By the weights of the closest: its scatter is 1.
  const double count = double(measured_count(data));
  Fit closest = out.stages[out.closest].fit;
  closest.weighted /= std::sqrt(closest.variance);  // found.sigma has it now
  closest.variance = 1;
  for (const Entry& entry : formulations()) {
    CatalogFit one = fit_one(entry, data, out);
    if (one.left_out.empty()) {
      one.error = std::sqrt(one.fit.sum_of_squares() / count);
      one.probability = probability_of(one.fit, closest);
    }
    out.catalog.push_back(std::move(one));
  }
  std::stable_sort(out.catalog.begin(), out.catalog.end(), [](const CatalogFit& a, const CatalogFit& b) {
    if (a.left_out.empty() != b.left_out.empty()) return a.left_out.empty();
    return a.error < b.error;
  });
  for (std::size_t i = 0; i < out.catalog.size() && out.catalog[i].left_out.empty(); ++i) {
    if (out.best < 0) out.best = int(i);
    if (out.best_conservative < 0 && out.catalog[i].is_conservative) out.best_conservative = int(i);
  }
}

}  // namespace halfway::reference::identify
