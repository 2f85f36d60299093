// Thousands of periods of bodies on every formulation: who makes energy, and who angular momentum.
#include "reference/record/effort.hpp"
#include "verify/once.hpp"
#include "verify/oracle/kept.hpp"
#include "verify/oracle/property.hpp"
#include "verify/studies/motion/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

namespace d = reference::dynamics;

/// Twice the largest that the integrator makes of any joint with a potential.
constexpr double kIntegrator = 1e-3;

/// Two free bodies tumble chaotically: how much energy is made in thousands of periods depends on rounding.
/// In the first fifty it does not, yet.
constexpr double kRegular = 50;

/// Kept from this code: the largest change of energy in those, and of angular momentum where moments do not
/// balance.
struct Kept {
  std::string_view name;
  double energy, angular_momentum;
};
constexpr Kept kKept[] = {{"attached_a", 0.355864, 0},
                          {"attached_b", 2.59136, 0},
                          {"invariant", 0.00167456, 0},
                          {"intrinsic", 0.134849, 0},
                          {"field_a", 1.98884, 0},
                          {"field_b", 0.108137, 0},
                          {"drake_rpy", 0.00722009, 0},
                          {"chrono_body", 2.7337, 0.18535},
                          {"exudyn_intrinsic", 0.00561213, 0.00200424},
                          {"mbdyn_joint_inv", 4.10577, 0}};

/// Within 1 %: other processors round otherwise, which fifty periods do not yet magnify so far. Of a
/// formulation that is not kept, anything beyond the integrator.
Band kept_band(const Entry& entry, double Kept::*what) {
  const auto* kept = kept_of(kKept, entry);
  if (kept == nullptr) return {1.5 * kIntegrator, 1e4};
  return {0.99 * (kept->*what), 1.01 * (kept->*what)};
}

/// The band of the energy change. A body on a clamped joint moves regularly: another rounding changes no
/// digit.
Band leak(const Entry& entry, Kind kind) {
  return kind == Kind::angular ? entry.facts.clamped_energy : kept_band(entry, &Kept::energy);
}

Draft of_run(const Entry& entry, Kind kind, const char* property, double value, const d::Drift& run) {
  return property_finding(entry, kind, property)
      .measured(value, fmt::format("{:.4g} periods; {}", run.periods,
                                   run.ending.empty() ? "all of them" : run.ending))
      .in("relative");
}

/// With a potential the energy error is the integrator's, and does not grow.
std::vector<Finding> conserved(const Entry& entry, Kind kind, const d::Drift& run, double by_half_steps) {
  const double size = run.ending.empty() ? run.largest_energy : std::nan("");
  Extent early;
  for (const auto& s : run.samples) {
    if (s.period <= 100) early.include(std::abs(s.energy));
  }
  return {
      of_run(entry, kind, "energy_drift", size, run)
          .at_most(kIntegrator,
                   "fourth order at 20 steps in the fastest period: falls sixteenfold at half the step")
          .by(Oracle::closed_form),
      of_run(entry, kind, "energy_growth", size / early.high(), run)
          .in("largest error of all periods over that of the first hundred")
          .at_most(
              2, "a symplectic integrator's error is bounded: later periods only visit more poses, up to 1.6")
          .by(Oracle::closed_form),
      of_run(entry, kind, "energy_half_steps", by_half_steps, run)
          .at_most(0.08,
                   "energy error at half the step over that at the whole, 30 periods: 2^-4, sampled at "
                   "other instants")
          .by(Oracle::closed_form)};
}

/// Without one the energy wanders or grows by far more than the integrator's share, at half the step as well.
std::vector<Finding> leaking(const Entry& entry, Kind kind, const d::Drift& run, const d::Drift& whole,
                             double by_half_steps) {
  const Band band = leak(entry, kind);
  return {of_run(entry, kind, "energy_long_run", whole.largest_energy, whole)
              .reported("how far it goes depends on rounding where bodies are free"),
          of_run(entry, kind, "energy_drift", run.largest_energy, run)
              .within(band.low, band.high,
                      "no potential: kinetic energy and the law's own; known failure, far beyond the "
                      "integrator's share")
              .by(Oracle::kept),
          of_run(entry, kind, "energy_half_steps", by_half_steps, run)
              .within(0.5, 2,
                      "energy change at half the step over that at the whole, 30 periods: 1 if the joint's, "
                      "1/16 if the integrator's")
              .by(Oracle::closed_form)};
}

/// Momenta of two free bodies. Steps of fourth order have three kicks.
std::vector<Finding> momenta(const Entry& entry, Kind kind, const d::Drift& start, const d::Drift& run) {
  constexpr double kEps = std::numeric_limits<double>::epsilon();
  const double made = std::sqrt(1 + run.largest_energy);  // rounding grows with the motion itself
  const bool balances = entry.facts.moment_balance.of(kind).holds();
  const Band band = kept_band(entry, &Kept::angular_momentum);
  Draft angular = balances ? of_run(entry, kind, "angular_momentum_drift", run.angular, run)
                           : of_run(entry, kind, "angular_momentum_drift", start.angular, start);
  if (balances)
    angular
        .at_most(2 * kEps * std::sqrt(3 * double(run.steps)) * made,
                 "moments balance: each kick rounds independently")
        .by(Oracle::closed_form);
  else
    angular
        .within(band.low, band.high,
                "moments do not balance: two free bodies wind themselves up, seen far above rounding")
        .by(Oracle::kept);
  return {of_run(entry, kind, "momentum_drift", run.linear, run)
              .at_most(4 * kEps * made, "forces are exact opposites: rounding of the sum alone")
              .by(Oracle::closed_form),
          angular};
}

std::vector<Finding> long_run(const Entry& entry, Kind kind) {
  const bool free = kind != Kind::angular;
  const auto scenario = motion_scenario(entry, kind);
  const auto largest = [&](int steps) {
    d::DriftSettings few;
    few.periods = 30;
    few.steps_per_fastest = steps;
    return measure_drift(entry, scenario, few).largest_energy;
  };
  const d::DriftSettings settings;
  const double by_half_steps = largest(2 * settings.steps_per_fastest) / largest(settings.steps_per_fastest);
  const d::Drift& run = long_motion(entry, kind);
  d::DriftSettings regular;
  if (free) regular.periods = kRegular;
  const d::Drift start = free ? measure_drift(entry, scenario, regular) : run;
  auto out = entry.has_potential(kind) ? conserved(entry, kind, run, by_half_steps)
                                       : leaking(entry, kind, start, run, by_half_steps);
  if (free) {
    for (auto& f : momenta(entry, kind, start, run)) out.push_back(f);
  }
  return out;
}

}  // namespace

d::Scenario motion_scenario(const Entry& entry, Kind kind) {
  return kind == Kind::angular ? d::clamped_scenario(entry) : d::free_scenario(entry);
}

const d::Drift& long_motion(const Entry& entry, Kind kind) {
  static Once<d::Drift, Kind> known;
  return known(entry, kind, [&] {
    d::DriftSettings settings;
    // The energy that a clamped joint without potential makes is held in a band of all periods.
    if (kind != Kind::angular || entry.has_potential(kind)) settings.periods = by_effort(2000, 200);
    return measure_drift(entry, motion_scenario(entry, kind), settings);
  });
}

void energy_drift(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    for (Kind kind : {Kind::angular, Kind::linear_angular}) {
      checks.push_back({fmt::format("{}/{}/long_run", entry.name, to_string(kind)), "stability",
                        [&entry, kind] { return long_run(entry, kind); }});
    }
  }
}

}  // namespace halfway::verify
