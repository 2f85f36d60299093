#include "reports/views/stability_energy.hpp"

#include "reference/record/worst.hpp"
#include "reference/solve/dynamics/drift.hpp"
#include "verify/oracle/measures.hpp"

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

using MakeScenario = d::Scenario (*)(const Entry&);
constexpr MakeScenario kScenarios[] = {&d::clamped_scenario, &d::free_scenario};

json scenario_row(const d::Scenario& scenario, const Entry& entry) {
  const auto modes = frequencies(entry, scenario);
  return {{"name", scenario.name},
          {"title", scenario.title},
          {"kind", to_string(scenario.spec.kind)},
          {"period", modes.empty() ? std::nan("") : 2 * std::numbers::pi / modes.front()},
          {"frequencies", modes}};
}

/// Four digits: what a chart shows.
double rounded(double x) { return std::stod(fmt::format("{:.4g}", x)); }

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
    out.push_back({rounded(s.period), rounded(largest)});
    largest = 0;
    while (edge <= s.period) edge *= std::pow(10, 1 / kPerDecade);
  }
  return out;
}

json run_row(const Entry& entry, const d::Scenario& scenario) {
  const d::Drift run = measure_drift(entry, scenario, {});
  const bool clamped = scenario.bodies[0].clamped || scenario.bodies[1].clamped;
  const auto momentum = [&](double drift) { return clamped ? json(nullptr) : json(drift); };
  return {{"formulation", entry.name},
          {"scenario", scenario.name},
          {"potential", entry.has_potential(scenario.spec.kind)},
          {"balanced", entry.facts.moment_balance.of(scenario.spec.kind).holds()},
          {"periods", run.periods},
          {"steps", run.steps},
          {"ending", run.ending},
          {"largest", run.largest_energy},
          {"trend", run.trend},
          {"linear", momentum(run.linear)},
          {"angular", momentum(run.angular)},
          {"samples", envelope(run)}};
}

/// The loads of doubles on a loop of 50 digits: a chart needs no more, and they cost a tenth.
verify::JointUnderTest in_double(const Entry& entry) {
  verify::JointUnderTest out;
  out.loads = [&entry](const auto& spec, const auto& a, const auto& b, bool with_tangent) {
    NodeLoads<verify::Real50> loads;
    loads.q =
        node_loads<double>(entry, spec, reference::cast<double>(a), reference::cast<double>(b), with_tangent)
            .q.template cast<verify::Real50>();
    return loads;
  };
  return out;
}

json loop_row(const Entry& entry, Kind kind) {
  const auto joint = in_double(entry);
  const auto spec = verify::probes(entry, kind, 1, 0.8).front().spec;
  json points = json::array();
  double smallest = 0, next = 0;
  for (double amplitude = 0.0125; amplitude < 1; amplitude *= 2) {
    const int count = amplitude < 0.2 ? 40 : 100;  // rounding is left, but at the widest loops
    const auto work = verify::loop_work(joint, spec, amplitude, count);
    points.push_back({{"amplitude", amplitude}, {"relative", rounded(work.relative())}});
    if (points.size() == 1) smallest = double(work.net);
    if (points.size() == 2) next = double(work.net);
  }
  const bool leaks = !entry.facts.loop_work.of(kind).holds();
  return {{"formulation", entry.name},
          {"kind", to_string(kind)},
          {"slope", leaks ? json(std::log2(std::abs(next / smallest))) : json(nullptr)},
          {"points", points}};
}

}  // namespace

json stability_energy_record() {
  const auto entries = reference::formulations();
  const d::DriftSettings settings;
  json out = {{"integrator",
               {{"order", settings.order == d::Order::two ? 2 : 4},
                {"steps_per_fastest", settings.steps_per_fastest},
                {"periods", settings.periods}}}};
  for (const MakeScenario make : kScenarios) {
    out["scenarios"].push_back(scenario_row(make(entries.front()), entries.front()));
    for (const Entry& entry : entries) out["runs"].push_back(run_row(entry, make(entry)));
  }
  for (const Entry& entry : entries) {
    for (const Kind kind : verify::kKinds) out["loops"].push_back(loop_row(entry, kind));
  }
  return out;
}

}  // namespace halfway::reports
