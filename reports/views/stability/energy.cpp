#include "reports/views/stability/energy.hpp"

#include "reference/record/worst.hpp"
#include "reports/views/rounded.hpp"
#include "verify/studies/motion/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace halfway::reports {
namespace {

using nlohmann::json;
using reference::Entry;
namespace d = reference::dynamics;

json scenario_row(const d::Scenario& scenario, const Entry& entry) {
  const auto modes = frequencies(entry, scenario);
  return {{"name", scenario.name},
          {"title", scenario.title},
          {"kind", to_string(scenario.joints.front().spec.kind)},
          {"period", modes.empty() ? std::nan("") : 2 * std::numbers::pi / modes.front()},
          {"frequencies", modes}};
}

/// The envelope of the energy change over equal steps of log(period).
json envelope(const d::Drift& run) {
  constexpr double kPerDecade = 30;
  json out = json::array();
  double largest = 0, edge = 0;
  for (const auto& s : run.samples) {
    if (s.period == 0) continue;
    if (edge == 0) edge = s.period;
    reference::keep_largest(largest, std::abs(s.energy));
    if (s.period < edge && &s != &run.samples.back()) continue;
    out.push_back({rounded(s.period, 4), rounded(largest, 4)});
    largest = 0;
    while (edge <= s.period) edge *= std::pow(10, 1 / kPerDecade);
  }
  return out;
}

json run_row(const Entry& entry, verify::Motion motion) {
  const d::Scenario scenario = verify::motion_scenario(entry, motion);
  const d::Drift& run = verify::long_motion(entry, motion);
  const bool clamped = std::ranges::any_of(scenario.bodies, &d::Body::clamped);
  const auto momentum = [&](double drift) { return clamped ? json(nullptr) : json(drift); };
  return {{"formulation", entry.name},
          {"scenario", scenario.name},
          {"potential", entry.has_potential(scenario.joints.front().spec.kind)},
          {"balanced", entry.facts.moment_balance.of(scenario.joints.front().spec.kind).holds()},
          {"periods", run.periods},
          {"steps", run.steps},
          {"ending", run.ending},
          {"largest", run.largest_energy},
          {"trend", run.trend},
          {"linear", momentum(run.linear)},
          {"angular", momentum(run.angular)},
          {"samples", envelope(run)}};
}

json loop_row(const Entry& entry, Kind kind) {
  json points = json::array();
  for (const verify::WideLoop& loop : verify::wide_loops(entry, kind))
    points.push_back({{"amplitude", loop.amplitude}, {"relative", rounded(loop.relative, 4)}});
  const bool leaks = !entry.facts.loop_work.of(kind).holds();
  return {{"formulation", entry.name},
          {"kind", to_string(kind)},
          {"slope", leaks ? json(verify::small_loops(entry, kind).order()) : json(nullptr)},
          {"points", points}};
}

}  // namespace

json stability_energy_record() {
  const auto entries = reference::formulations();
  const d::DriftSettings settings;
  json out = {{"integrator",
               {{"order", settings.order == d::Order::two ? 2 : 4},
                {"steps_per_fastest", settings.steps_per_fastest}}}};
  for (const verify::Motion motion : verify::kMotions) {
    const Entry& first = entries.front();
    out["scenarios"].push_back(scenario_row(verify::motion_scenario(first, motion), first));
    for (const Entry& entry : entries) out["runs"].push_back(run_row(entry, motion));
  }
  for (const Entry& entry : entries) {
    for (const Kind kind : verify::kKinds) out["loops"].push_back(loop_row(entry, kind));
  }
  return out;
}

}  // namespace halfway::reports
