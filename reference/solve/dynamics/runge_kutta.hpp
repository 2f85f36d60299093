// The other road: GSL's embedded Runge-Kutta pair of order 8 with step control, for any loads.
#pragma once

#include "reference/solve/dynamics/bodies.hpp"

#include <memory>
#include <string>

namespace halfway::reference::dynamics {

/// A motion on its way, from time 0 on.
class RungeKutta {
 public:
  /// The system must outlive it. @param tolerance  of each step, relative to each number and absolute (SI
  /// units); 1e-14 ... 1e-3
  /// @param per_mass  absolute of momenta in m/s and rad/s instead: over the body's mass and largest inertia
  RungeKutta(const System& system, const State& start, double tolerance, bool per_mass = false);
  ~RungeKutta();
  RungeKutta(const RungeKutta&) = delete;
  RungeKutta& operator=(const RungeKutta&) = delete;

  /// On to a time, s. @return  "", or why it stopped early; the state is then the last good one.
  std::string advance(double time);

  State state() const;
  double dissipated() const;  ///< integral of System::dissipation, J
  Driven driven() const;      ///< work: integral of the power of System::drive, J
  double norm_drift()
      const;  ///< largest deviation of a quaternion's norm from 1 in one step, before it is undone
  long evaluations() const;  ///< of the loads

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

struct RungeKuttaResult {
  State state;
  double dissipated = 0;  ///< as of RungeKutta, and the others
  double norm_drift = 0;
  long evaluations = 0;
  std::string failure{};
};

RungeKuttaResult runge_kutta(const System& system, const State& start, double duration, double tolerance);

}  // namespace halfway::reference::dynamics
