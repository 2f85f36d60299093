// The other road: GSL's embedded Runge-Kutta pair of order 8 with step control, for any loads.
#pragma once

#include "reference/solve/dynamics/bodies.hpp"

#include <memory>
#include <string>

namespace halfway::reference::dynamics {

/// A motion on its way, from time 0 on.
class RungeKutta {
 public:
  /// How it steps.
  struct Options {
    double tolerance =
        1e-9;  ///< of each step, relative to each number and absolute (SI units); 1e-14 ... 1e-3
    bool per_mass =
        false;  ///< absolute of momenta in m/s and rad/s: over the body's mass and largest inertia
    long most_steps = 4'000'000;  ///< an hour's worth: a run that needs more has a named end
  };
  /// The system must outlive it.
  RungeKutta(const System& system, const State& start, const Options& options);
  ~RungeKutta();
  RungeKutta(const RungeKutta&) = delete;
  RungeKutta& operator=(const RungeKutta&) = delete;

  /// On to a time, s. @return  "", or why it stopped early; the state is then the last good one.
  std::string advance(double time);

  /// Forgets the rates of the last step: the loads jump here.
  void restart();

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
