// The other road: GSL's embedded Runge-Kutta pair of order 8 with step control, for any loads.
#pragma once

#include "reference/solve/dynamics/bodies.hpp"

#include <string>

namespace halfway::reference::dynamics {

struct RungeKuttaResult {
  State state;
  double dissipated = 0;  ///< integral of System::dissipation, J
  double norm_drift =
      0;                 ///< largest deviation of a quaternion's norm from 1 in one step, before it is undone
  long evaluations = 0;  ///< of the loads
  std::string failure{};  ///< empty, or why it stopped early; the state is then the last good one
};

/// @param tolerance  of each step, relative to each number and absolute (SI units); 1e-14 ... 1e-3
RungeKuttaResult runge_kutta(const System& system, const State& start, double duration, double tolerance);

}  // namespace halfway::reference::dynamics
