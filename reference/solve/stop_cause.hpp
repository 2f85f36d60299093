// Why load stepping ended where it did, from the state that it reached.
#pragma once

#include "reference/solve/equilibrium_problem.hpp"

namespace halfway::reference {

enum class StopCause {
  half_turn,  ///< rotation vectors jump at phi = pi
  jump,       ///< an Euler angle does, at another phi
  pole,       ///< the tangent has grown without bound: gimbal lock, or a measure's own end
  fold,       ///< the load factor has a maximum on the path
  branching,  ///< the tangent is singular and the load does not see it
  unknown
};

StopCause stop_cause(const EquilibriumProblem<double>& problem, const Outcome<double>& state);

/// In the words of an outcome.
const char* to_string(StopCause cause);

}  // namespace halfway::reference
