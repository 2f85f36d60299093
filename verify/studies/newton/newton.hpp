// Plain Newton in one load step: no damping, no load steps, no line search. The subject, not a tool.
#pragma once

#include "reference/solve/equilibrium_problem.hpp"

#include <array>
#include <vector>

namespace halfway::reference {

/// What Newton solves with in place of d(internal - applied)/d(pose).
enum class NewtonTangent {
  analytic,
  symmetrised,        ///< (J + J^T)/2: what a solver for symmetric matrices is given
  frozen,             ///< that of the start, for all iterations
  forward_difference  ///< a column by one more residual, step kDifferenceStep
};
inline constexpr std::array kNewtonTangents = {NewtonTangent::analytic, NewtonTangent::symmetrised,
                                               NewtonTangent::frozen, NewtonTangent::forward_difference};
const char* to_string(NewtonTangent tangent);

/// rad and m: the square root of the rounding of a double, where the error of a forward difference of
/// a well scaled function is least.
inline constexpr double kDifferenceStep = 0x1p-26;

/// rad; a tangent that asks for more counts as singular: what is left of such a step modulo 2 pi is noise.
inline constexpr double kLongestStep = 1e6;

enum class NewtonEnd { converged, too_many_iterations, singular_tangent, not_finite };
const char* to_string(NewtonEnd end);

template <class T>
struct NewtonRun {
  NewtonEnd end = NewtonEnd::too_many_iterations;
  int iterations = 0;          ///< steps taken
  bool has_wrapped = false;    ///< a step was longer than pi rad: the retraction kept its remainder
  std::vector<Pose<T>> poses;  ///< the start and every iterate; the last is the result
};

/// The tangent at b, in the unknowns of the problem.
template <class T>
NodeMatrix<T> newton_tangent(const EquilibriumProblem<T>& problem, NewtonTangent tangent, const Pose<T>& b,
                             const T& factor);

/// Iterates from `start` at one load factor until the imbalance is rounding: 64 eps of the load and of
/// the unstrained tangent times 1 rad. Every step goes through R <- exp(w) R, whatever its length: exp is
/// defined for all w and takes a step longer than pi as the shorter rotation that it is. A tangent whose
/// pivots span more than the digits of T counts as singular. For angular joints: steps are rad, and pivots
/// have one unit.
template <class T>
NewtonRun<T> plain_newton(const EquilibriumProblem<T>& problem, NewtonTangent tangent, const Pose<T>& start,
                          const T& factor, int most_iterations);

}  // namespace halfway::reference
