#include "reference/solve/dynamics/drift.hpp"

#include "reference/numbers/linear_algebra.hpp"
#include "reference/record/worst.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace halfway::reference::dynamics {
namespace {

double slope(const std::vector<DriftSample>& samples) {
  std::vector<std::array<double, 2>> points;
  for (const auto& s : samples) points.push_back({s.period, s.energy});
  return slope_of(points);
}

/// Momentum and angular momentum of the start's whole energy in the bodies together.
struct Scales {
  double linear, angular;
};
Scales scales(const std::vector<Body>& bodies, double start_energy) {
  double mass = 0, inertia = 0;
  for (const Body& body : bodies) mass += body.mass, inertia += body.inertia.maxCoeff();
  return {std::sqrt(2 * start_energy * mass), std::sqrt(2 * start_energy * inertia)};
}

/// A joint without stiffness at rest, or whose stiffness is no number, has no period to count.
Drift without_modes() {
  Drift out;
  out.largest_energy = out.trend = out.linear = out.angular = std::nan("");
  out.ending = "no stiffness at rest";
  return out;
}

}  // namespace

Drift measure_drift(const Entry& entry, const Scenario& scenario, const DriftSettings& settings) {
  const System system = elastic_system(entry, scenario.joints, scenario.bodies);
  const auto modes = frequencies(entry, scenario);
  if (modes.empty()) return without_modes();
  const double period = 2 * std::numbers::pi / modes.front();
  const int per_period =
      std::max(1, int(std::ceil(settings.steps_per_fastest * modes.back() / modes.front())));
  const int stride = std::max(1, per_period / settings.samples_per_period);
  const double h = period / per_period;
  const bool is_free = std::ranges::none_of(scenario.bodies, &Body::clamped);
  const double E0 = energy(system, scenario.start);
  const Momenta M0 = momenta(scenario.start);
  const Scales scale = scales(scenario.bodies, E0);

  Drift out;
  State state = scenario.start;
  out.samples.push_back({0, 0});
  while (out.periods < settings.periods && out.ending.empty()) {
    advance(system, settings.order, h, stride, state);
    out.steps += stride;
    out.periods = double(out.steps) / per_period;
    const double change = (energy(system, state) - E0) / E0;
    const Momenta M = momenta(state);
    if (!std::isfinite(change)) {
      out.ending = "the loads are not finite";
      out.largest_energy = out.linear = out.angular = std::nan("");
      break;
    }
    out.samples.push_back({out.periods, change});
    keep_largest(out.largest_energy, std::abs(change));
    if (is_free) {
      keep_largest(out.linear, (M.linear - M0.linear).norm() / scale.linear);
      keep_largest(out.angular, (M.angular - M0.angular).norm() / scale.angular);
    }
    if (std::abs(change) > settings.largest_growth) {
      out.ending = "the joint made many times the energy of the start";
    } else if (relative_angle(scenario.joints, state) > settings.largest_angle) {
      out.ending = "the joint turned beyond the range of its rotation measure";
    }
  }
  out.trend = slope(out.samples);
  return out;
}

}  // namespace halfway::reference::dynamics
