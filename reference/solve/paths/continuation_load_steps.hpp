// Load stepping without any guard, as programs do it: the comparison for the continuation. Each step
// starts from the last state and takes the root that it finds, on whatever path that lies.
#pragma once

#include "reference/solve/paths/continuation.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

struct LoadSteps {
  std::vector<ArcState<double>> states;  ///< as many as converged, the unstrained pose first
  bool converged = false;                ///< to the last load factor
  std::string message;                   ///< the solver's own words when not
};

/// Newton with the analytic tangent, whole steps, up to 50 iterations for each load factor.
LoadSteps newton_load_steps(const EquilibriumProblem<double>& problem, double end_factor, int steps);

/// GSL's hybrid method with finite differences (gsl_hybrids) for each load factor.
LoadSteps gsl_load_steps(const EquilibriumProblem<double>& problem, double end_factor, int steps);

/// How far a state is from what the continuous path has at its load factor, in the path's scales (rad), from
/// the nearest of several; NaN where the path has nothing there.
double distance_off_path(const Continuation& continuation, const EquilibriumPath& path,
                         const ArcState<double>& state);

/// Which of the states lie elsewhere than on the path.
struct OffPath {
  int count = 0;                ///< of states
  double first_factor = 0;      ///< load factor of the first of them
  double largest_distance = 0;  ///< of states whose load factor the path has
};
OffPath off_path(const Continuation& continuation, const EquilibriumPath& path, const LoadSteps& steps);

}  // namespace halfway::reference
