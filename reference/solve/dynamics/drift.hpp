// Long runs of bodies on a joint: what of energy and momentum a formulation loses or makes.
#pragma once

#include "reference/solve/dynamics/splitting.hpp"

#include <string>
#include <vector>

namespace halfway::reference::dynamics {

/// Bodies, joints and start. One period is that of the slowest mode of small vibration.
struct Scenario {
  std::string name;
  std::string title;
  std::vector<Joint> joints;
  std::vector<Body> bodies;
  State start;
};

/// A body turning about its centre on an angular joint to a clamped node: K = diag(1, 10, 100) N m/rad, about
/// 0.5 rad.
Scenario clamped_scenario(const Entry& entry);

/// Two free bodies that also tumble, on a linear/angular joint off their centres, linear momentum 0.
Scenario free_scenario(const Entry& entry);

/// A chain of sixteen links that nothing holds: curved and without load, at the start bent and twisted
/// further by up to 0.14 rad a joint, spinning and moving. Joints at the middle between their nodes, in
/// frames turned from the links' axes of inertia. A rod of length 1 m, GJ = 0.8, EI = (1, 4) N m^2.
Scenario chain_scenario(const Entry& entry);

/// Circular frequencies of small vibration about the unstrained pose, rad/s, ascending; those of rigid motion
/// are left out. Empty where the tangent there is zero or no number.
std::vector<double> frequencies(const Entry& entry, const Scenario& scenario);

struct DriftSettings {
  double periods = 2000;
  int steps_per_fastest = 20;  ///< in a period of the fastest mode
  Order order = Order::four;
  int samples_per_period = 3;   ///< at which energy and momentum are looked at
  double largest_angle = 3;     ///< rad; a joint that turns further has left the range of all measures
  double largest_growth = 100;  ///< of the energy, relative: there a run ends
};

struct DriftSample {
  double period, energy;  ///< energy: (E - E(0))/E(0)
};

struct Drift {
  std::vector<DriftSample> samples;
  double periods = 0;         ///< reached
  double largest_energy = 0;  ///< largest |E - E(0)|/E(0)
  double trend = 0;           ///< least-squares slope of (E - E(0))/E(0), per period
  double linear = 0;          ///< largest |P - P(0)| over the momentum that all of E(0) could make
  double angular = 0;  ///< the same of the angular momentum about the origin; 0 where a body is clamped
  long steps = 0;
  std::string ending{};  ///< empty: all periods; or why it stopped
};

Drift measure_drift(const Entry& entry, const Scenario& scenario, const DriftSettings& settings);

}  // namespace halfway::reference::dynamics
