// The full nonlinear motion of a body on an angular joint under a moment, next to an equilibrium of the
// primary path: what the eigenvalues say, by a road that knows no tangent.
#pragma once

#include "reference/solve/stability/critical.hpp"

#include <complex>
#include <optional>

namespace halfway::reference {

struct MotionRequest {
  const Entry* entry;
  JointSpec spec;
  int axis;
  MomentSetting setting;
  BodyInertia body;
  double angle;  ///< of the equilibrium, rad
};

/// Deviation from the equilibrium (rotation vector, axes of the clamped joint frame, rad) at equal intervals.
struct DeviationHistory {
  double interval = 0;  ///< s
  std::vector<Vec3<double>> theta;
  bool finished = false;  ///< false: the integrator gave up; the history ends there
};

/// I w' + w x I w = applied - internal moment, the orientation a unit quaternion, by GSL's rk8pd with a
/// tolerance of 1e-13 (the growing part of 1e-6 rad stays exact to 1e-6), from rest at 1e-6 rad off the
/// equilibrium in a direction without symmetry.
DeviationHistory disturbed_motion(const MotionRequest& request, double duration, int points);

/// Growth rate and frequency of the mode that dominates the last `points` of a history, by Prony's recurrence
/// y(n+2) = 2 e^(s h) cos(f h) y(n+1) - e^(2 s h) y(n), least squares over all components: s + i f, 1/s.
/// Nothing when the recurrence has no complex solution.
std::optional<std::complex<double>> dominating_mode(const DeviationHistory& history, int points);

}  // namespace halfway::reference
