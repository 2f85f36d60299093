// Thousands of periods of bodies on every formulation, and tens of a chain: who makes energy, and who angular
// momentum.
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

constexpr double kEps = std::numeric_limits<double>::epsilon();

/// Twice the largest that the integrator makes of any joint with a potential.
constexpr double kIntegrator = 1e-3;
/// The same of a chain in its first periods, when its slow modes have the energy.
constexpr double kInFirstPeriods = 1e-5;

/// How long each is looked at, in periods of its slowest mode. Two free bodies tumble chaotically, and so do
/// the links of a chain: how much energy is made in the long run depends on rounding. In the first periods it
/// does not, yet.
struct Look {
  const char* prefix;              ///< of the findings' names
  double periods, quick, regular;  ///< of the whole run; with little effort; in which rounding does not tell
  double halved;                   ///< with half the step
};
Look look(Motion motion) {
  switch (motion) {
    case Motion::clamped:
      return {"", 2000, 200, 2000, 30};
    case Motion::free:
      return {"", 2000, 200, 50, 30};
    case Motion::chain:
      return {"chain/", 20, 3, 3, 3};
  }
  return {};
}

d::Drift drift_of(const Entry& entry, Motion motion, double periods, int steps_per_fastest = 20) {
  d::DriftSettings settings;
  settings.periods = periods, settings.steps_per_fastest = steps_per_fastest;
  return measure_drift(entry, motion_scenario(entry, motion), settings);
}

/// Kept from this code: the largest change of energy in the first periods, and of angular momentum where
/// moments do not balance; of two free bodies and of a chain.
struct Leak {
  double energy, angular_momentum;
};
struct Kept {
  std::string_view name;
  Leak free, chain;
};
constexpr Kept kKept[] = {{"attached_a", {0.355864, 0}, {0.257015, 0}},
                          {"attached_b", {2.59136, 0}, {0.300934, 0}},
                          {"invariant", {0.00167456, 0}, {0.000704711, 0}},
                          {"intrinsic", {0.134849, 0}, {0.0268604, 0}},
                          {"field_a", {1.98884, 0}, {0.249411, 0}},
                          {"field_b", {0.108137, 0}, {0.6501, 0}},
                          {"drake_rpy", {0.00722009, 0}, {0.00035767, 0}},
                          {"chrono_body", {2.7337, 0.18535}, {0.512561, 0.0525186}},
                          {"exudyn_intrinsic", {0.00561213, 0.00200424}, {0.000345595, 5.91007e-05}},
                          {"mbdyn_joint_inv", {4.10577, 0}, {3.60815, 0}}};

/// Within 1 %: other processors round otherwise, which the first periods do not yet magnify so far. Of a
/// formulation that is not kept, anything beyond the integrator.
Band kept_band(const Entry& entry, Motion motion, double Leak::*what) {
  const auto* kept = kept_of(kKept, entry);
  const double made = motion == Motion::chain ? kInFirstPeriods : 1.5 * kIntegrator;
  if (kept == nullptr) return {made, 1e4};
  const double value = (motion == Motion::chain ? kept->chain : kept->free).*what;
  return {0.99 * value, 1.01 * value};
}

/// The band of the energy change. A body on a clamped joint moves regularly: another rounding changes no
/// digit.
Band leak(const Entry& entry, Motion motion) {
  return motion == Motion::clamped ? entry.facts.clamped_energy : kept_band(entry, motion, &Leak::energy);
}

/// Runs of one formulation.
struct Runs {
  Motion motion;
  const d::Drift& whole;
  d::Drift start;        ///< the regular part
  double by_half_steps;  ///< the largest change of energy with half the step, over that with the whole one
};

Draft of_run(const Entry& entry, Motion motion, const char* property, double value, const d::Drift& run) {
  return property_finding(entry, kind_of(motion), std::string(look(motion).prefix) + property)
      .measured(value, fmt::format("{:.4g} periods; {}", run.periods,
                                   run.ending.empty() ? "all of them" : run.ending))
      .in("relative");
}

/// Later periods only visit more poses, up to 1.6 times worse ones. A chain's energy goes over to its fast
/// modes, of which an integrator makes most, for hundreds of periods: nothing but energy_drift bounds it.
Finding grown(const Entry& entry, const Runs& runs) {
  Extent early;
  for (const auto& s : runs.whole.samples) {
    if (s.period <= 100) early.include(std::abs(s.energy));
  }
  return of_run(entry, runs.motion, "energy_growth", runs.whole.largest_energy / early.high(), runs.whole)
      .in("largest error of all periods over that of the first hundred")
      .at_most(2,
               "a symplectic integrator's error is bounded: later periods only visit more poses, up to 1.6")
      .by(Oracle::closed_form);
}

/// With a potential the energy error is the integrator's, and does not grow.
std::vector<Finding> conserved(const Entry& entry, const Runs& runs) {
  const d::Drift& run = runs.whole;
  std::vector<Finding> out = {
      of_run(entry, runs.motion, "energy_drift", run.ending.empty() ? run.largest_energy : std::nan(""), run)
          .at_most(kIntegrator,
                   "fourth order at 20 steps in the fastest period: falls sixteenfold at half the step")
          .by(Oracle::closed_form),
      of_run(entry, runs.motion, "energy_half_steps", runs.by_half_steps, run)
          .at_most(
              0.08,
              "energy error at half the step over that at the whole, in the first periods: 2^-4, sampled at "
              "other instants")
          .by(Oracle::closed_form)};
  if (runs.motion != Motion::chain) out.insert(out.begin() + 1, grown(entry, runs));
  return out;
}

/// Without one the energy wanders or grows by far more than the integrator's share, at half the step as well.
std::vector<Finding> leaking(const Entry& entry, const Runs& runs) {
  const Band band = leak(entry, runs.motion);
  const d::Drift &run = runs.start, &whole = runs.whole;
  return {of_run(entry, runs.motion, "energy_long_run", whole.largest_energy, whole)
              .reported("how far it goes depends on rounding where bodies are free"),
          of_run(entry, runs.motion, "energy_drift", run.largest_energy, run)
              .within(band.low, band.high,
                      "no potential: kinetic energy and the law's own; known failure, far beyond the "
                      "integrator's share")
              .by(Oracle::kept),
          of_run(entry, runs.motion, "energy_half_steps", runs.by_half_steps, run)
              .within(0.5, 2,
                      "energy change at half the step over that at the whole, in the first periods: 1 if the "
                      "joint's, 1/16 if the integrator's")
              .by(Oracle::closed_form)};
}

/// Two bodies' momenta round alike, with opposite signs. Those of a chain's links do not: each by up to eps/2
/// of what its share of the energy makes, in each kick.
double lost_momentum(Motion motion, const d::Drift& run) {
  constexpr double kLinks = 16;
  return motion == Motion::chain ? kEps * std::sqrt(3 * double(run.steps) / kLinks) : 4 * kEps;
}

/// Momenta of free bodies. Steps of fourth order have three kicks.
std::vector<Finding> momenta(const Entry& entry, const Runs& runs) {
  const d::Drift& run = runs.whole;
  const double made = std::sqrt(1 + run.largest_energy);  // rounding grows with the motion itself
  const bool balances = entry.facts.moment_balance.of(kind_of(runs.motion)).holds();
  const d::Drift& judged = balances ? run : runs.start;
  Draft angular = of_run(entry, runs.motion, "angular_momentum_drift", judged.angular, judged);
  if (balances) {
    angular
        .at_most(2 * kEps * std::sqrt(3 * double(run.steps)) * made,
                 "moments balance: each kick rounds independently")
        .by(Oracle::closed_form);
  } else {
    const Band band = kept_band(entry, runs.motion, &Leak::angular_momentum);
    angular
        .within(band.low, band.high,
                "moments do not balance: free bodies wind themselves up, seen far above rounding")
        .by(Oracle::kept);
  }
  return {of_run(entry, runs.motion, "momentum_drift", run.linear, run)
              .at_most(lost_momentum(runs.motion, run) * made,
                       "forces are exact opposites: rounding of the sums alone")
              .by(Oracle::closed_form),
          angular};
}

std::vector<Finding> long_run(const Entry& entry, Motion motion) {
  const Look& look = verify::look(motion);
  const auto largest = [&](int steps) { return drift_of(entry, motion, look.halved, steps).largest_energy; };
  const d::Drift& whole = long_motion(entry, motion);
  const Runs runs{motion, whole, look.regular < whole.periods ? drift_of(entry, motion, look.regular) : whole,
                  largest(40) / largest(20)};
  auto out = entry.has_potential(kind_of(motion)) ? conserved(entry, runs) : leaking(entry, runs);
  if (motion == Motion::clamped) return out;
  for (auto& f : momenta(entry, runs)) out.push_back(f);
  return out;
}

}  // namespace

Kind kind_of(Motion motion) { return motion == Motion::clamped ? Kind::angular : Kind::linear_angular; }

d::Scenario motion_scenario(const Entry& entry, Motion motion) {
  return motion == Motion::clamped ? d::clamped_scenario(entry)
         : motion == Motion::free  ? d::free_scenario(entry)
                                   : d::chain_scenario(entry);
}

const d::Drift& long_motion(const Entry& entry, Motion motion) {
  static Once<d::Drift, Motion> known;
  return known(entry, motion, [&] {
    const Look& l = look(motion);
    // The energy that a clamped joint without potential makes is held in a band of all periods.
    const bool all = motion == Motion::clamped && !entry.has_potential(Kind::angular);
    return drift_of(entry, motion, all ? l.periods : by_effort(int(l.periods), int(l.quick)));
  });
}

void energy_drift(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    for (const Motion motion : kMotions) {
      const std::string name =
          property_name(entry, kind_of(motion), look(motion).prefix + std::string("long_run"));
      checks.push_back({name, "stability", [&entry, motion] { return long_run(entry, motion); }});
    }
  }
}

}  // namespace halfway::verify
