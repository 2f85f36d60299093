// Thousands of periods of bodies on every formulation: who makes energy, and who angular momentum.
#include "reference/solve/dynamics/drift.hpp"
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

namespace d = reference::dynamics;

/// Twice the largest that the integrator makes of any joint with a potential.
constexpr double kIntegrator = 1e-3;

/// The band of the energy change. A body on a clamped joint moves regularly: another rounding changes no
/// digit. Two free bodies tumble chaotically: how much is made before the run ends depends on rounding, and
/// it ends between two samples beyond 100 times the start. So does a formulation that declares no band.
Band leak(const Entry& entry, Kind kind) {
  const Band declared = entry.facts.clamped_energy;
  return kind == Kind::angular && !declared.holds() ? declared : Band{1.5 * kIntegrator, 1e4};
}

Finding measured(const Entry& entry, Kind kind, const char* property, double value, const d::Drift& run) {
  Finding f = property_finding(entry, kind, property);
  f.value = value;
  f.unit = "relative";
  f.parameter =
      fmt::format("{:.4g} periods; {}", run.periods, run.ending.empty() ? "all of them" : run.ending);
  return f;
}

/// With a potential the energy error is the integrator's, and does not grow.
std::vector<Finding> conserved(const Entry& entry, Kind kind, const d::Drift& run, double by_half_steps) {
  Finding size = measured(entry, kind, "energy_drift", run.largest_energy, run);
  size.high = kIntegrator;
  size.reason = "fourth order at 20 steps in the fastest period: falls sixteenfold at half the step";
  if (!run.ending.empty()) size.value = std::nan("");
  double early = 0;
  for (const auto& s : run.samples) early = s.period <= 100 ? std::max(early, std::abs(s.energy)) : early;
  Finding growth = measured(entry, kind, "energy_growth", run.largest_energy / early, run);
  growth.unit = "largest error of all periods over that of the first hundred";
  growth.high = 2;
  growth.reason =
      "a symplectic integrator's error is bounded: later periods only visit more poses, up to 1.6";
  Finding order = measured(entry, kind, "energy_half_steps", by_half_steps, run);
  order.high = 0.08;
  order.reason =
      "energy error at half the step over that at the whole, 30 periods: 2^-4, sampled at other instants";
  return {size, growth, order};
}

/// Without one the energy wanders or grows by far more than the integrator's share, at half the step as well.
std::vector<Finding> leaking(const Entry& entry, Kind kind, const d::Drift& run, double by_half_steps) {
  Finding size = measured(entry, kind, "energy_drift", run.largest_energy, run);
  const Band band = leak(entry, kind);
  size.comparison = Comparison::within;
  size.low = band.low;
  size.high = band.high;
  size.reason =
      "no potential: kinetic energy and the law's own; known failure, far beyond the integrator's share";
  Finding order = measured(entry, kind, "energy_half_steps", by_half_steps, run);
  order.comparison = Comparison::within;
  order.low = 0.5;
  order.high = 2;
  order.reason =
      "energy change at half the step over that at the whole, 30 periods: 1 if the joint's, 1/16 if the "
      "integrator's";
  return {size, order};
}

/// Momenta of two free bodies. Steps of fourth order have three kicks.
std::vector<Finding> momenta(const Entry& entry, Kind kind, const d::Drift& run) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const double made = std::sqrt(1 + run.largest_energy);  // rounding grows with the motion itself
  Finding linear = measured(entry, kind, "momentum_drift", run.linear, run);
  linear.high = 4 * kEps * made;
  linear.oracle = Oracle::closed_form;
  linear.reason = "forces are exact opposites: rounding of the sum alone";
  Finding angular = measured(entry, kind, "angular_momentum_drift", run.angular, run);
  angular.oracle = Oracle::closed_form;
  if (entry.facts.moment_balance.of(kind).holds()) {
    angular.high = 2 * kEps * std::sqrt(3 * double(run.steps)) * made;
    angular.reason = "moments balance: each kick rounds independently";
  } else {
    angular.comparison = Comparison::within;
    angular.low = 1e-4;
    angular.high = 1e3;
    angular.reason = "moments do not balance: two free bodies wind themselves up, seen far above rounding";
  }
  return {linear, angular};
}

std::vector<Finding> long_run(const Entry& entry, Kind kind) {
  const bool free = kind != Kind::angular;
  const auto scenario = free ? d::free_scenario(entry) : d::clamped_scenario(entry);
  const auto largest = [&](int steps) {
    d::DriftSettings few;
    few.periods = 30;
    few.steps_per_fastest = steps;
    return measure_drift(entry, scenario, few).largest_energy;
  };
  const d::DriftSettings settings;
  const double by_half_steps = largest(2 * settings.steps_per_fastest) / largest(settings.steps_per_fastest);
  const d::Drift run = measure_drift(entry, scenario, settings);
  auto out = entry.has_potential(kind) ? conserved(entry, kind, run, by_half_steps)
                                       : leaking(entry, kind, run, by_half_steps);
  if (free) {
    for (auto& f : momenta(entry, kind, run)) out.push_back(f);
  }
  for (Finding& f : out) f = judged(f);
  return out;
}

}  // namespace

void energy_drift(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    for (Kind kind : {Kind::angular, Kind::linear_angular}) {
      checks.push_back({fmt::format("{}/{}/long_run", entry.name, to_string(kind)), "stability",
                        [&entry, kind] { return long_run(entry, kind); }});
    }
  }
}

}  // namespace halfway::verify
