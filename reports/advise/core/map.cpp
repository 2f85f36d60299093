#include "reports/advise/core/map.hpp"

#include "reference/record/worst.hpp"
#include "reports/advise/core/ratio.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::advise {
namespace {

constexpr double kRatios[] = {1, 2, 5, 10, 20, 50, 100, 200, 500};
constexpr double kMapMost = 2.1;  // rad
constexpr int kMapRows = 28;      // spaced evenly in the logarithm: a factor of 1.3

/// Loads whose rotations go from kMapLeast to kMapMost by the linear analysis, each a factor further.
std::vector<double> loads_of(const reference::Scene& scene) {
  const Answers linear = follow(scene, {nullptr, 0.5, false, scene.joint.kind}, {1});
  const double turn = rotation_at(linear, 0).value_or(0);
  std::vector<double> out;
  for (int i = 0; i < kMapRows && turn > 0; ++i)
    out.push_back(kMapLeast / turn * std::pow(kMapMost / kMapLeast, i / (kMapRows - 1.)));
  return out;
}

/// Errors and what disqualifies, whichever is more, row by row.
std::vector<double> against(const Question& question, const Candidate& c, const Answers& path,
                            const Answers& truth, Measure measure) {
  std::vector<double> out = errors_of(path, truth, measure);
  for (std::size_t i = 0; i < path.node.size() && i < out.size(); ++i) {
    Answers one;
    one.node = {path.node[i]};
    const Defects defects = defects_of(question, c, one, 1);
    for (const double defect : {defects.node_order, defects.balance, defects.energy, defects.spin})
      reference::keep_largest(out[i], defect);
  }
  const std::vector<double> order = node_order_errors(question.scene, c, path);
  for (std::size_t i = 0; i < order.size() && i < out.size(); ++i) reference::keep_largest(out[i], order[i]);
  return out;
}

struct Candidacy {
  std::string name, formulation;
  double cost, reach;
};

/// The cheapest at each rotation: who reaches farther than all cheaper ones.
MapColumn column_of(double ratio, std::vector<Candidacy> all, double end) {
  std::ranges::stable_sort(all, {}, &Candidacy::cost);
  MapColumn out{ratio};
  for (const Candidacy& c : all) {
    const double from = out.pieces.empty() ? 0 : out.pieces.back().to;
    if (c.reach > from * 1.02 && c.reach >= kMapLeast) out.pieces.push_back({c.reach, c.name, c.formulation});
  }
  if (out.pieces.empty() || out.pieces.back().to < end) out.pieces.push_back({end});
  return out;
}

}  // namespace

std::vector<MapColumn> adequacy_map(const Advice& advice, const std::map<std::string, Cost>& costs) {
  std::vector<MapColumn> out;
  if (!has_other_ratios(advice)) return out;
  for (const double ratio : kRatios) {
    Question question = advice.question;
    question.scene = with_ratio(advice.truth.scene, ratio);
    const Truth truth = truth_of(question.scene, question.truth);
    const std::vector<double> loads = loads_of(question.scene);
    const Answers exact = truth.at(loads);
    if (exact.value.empty()) continue;
    std::vector<Candidacy> all;
    for (const Candidate& c : candidates_of(question.scene)) {
      const auto cost = costs.find(c.timing());
      if (cost == costs.end() || !(cost->second.ns > 0)) continue;
      const Answers path = follow(question.scene, c, loads);
      const Reach reach =
          reach_of(against(question, c, path, exact, advice.measure()), exact, question.tolerance);
      all.push_back({c.name(question.scene.joint.kind), c.formulation(), cost->second.ns, reach.rotation});
    }
    double end = 0;
    for (std::size_t i = 0; i < exact.value.size(); ++i)
      reference::keep_largest(end, rotation_at(exact, i).value_or(0));
    out.push_back(column_of(ratio, std::move(all), end));
  }
  return out;
}

}  // namespace halfway::advise
