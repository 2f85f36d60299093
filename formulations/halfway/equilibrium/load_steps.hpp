// Load steps: how far each goes, and when there is no going on.
#pragma once

#include "halfway/equilibrium/newton.hpp"
#include "halfway/rotations/scalar.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <optional>

namespace halfway {

enum class Status {
  converged,         ///< accurate to SolverOptions::accuracy, or better
  inaccurate,        ///< an equilibrium, but rounding lets Outcome::error be no smaller than it says
  singular_tangent,  ///< the tangent cannot be solved with: a limit point or a mechanism
  no_convergence     ///< no load step, however small, converges on the same branch
};

/// Was a state of equilibrium reached, whatever digits of it are known?
inline bool is_equilibrium(Status status) {
  return status == Status::converged || status == Status::inaccurate;
}

template <class T>
struct SolverOptions {
  /// Relative error of the motion up to which an answer counts as converged.
  T accuracy = std::max(T(1e-9), T(4096) * T(Eigen::NumTraits<T>::epsilon()));
  T smallest_step = T(1e-9);  ///< of the load factor, relative to the whole advance
  T largest_turn = T(0.35);   ///< rad between accepted states; a longer step may change branch
  /// Of the motion so far, and rad at most, between accepted states whose tangents' determinants differ in
  /// sign. A path that branches there is followed through in such steps; one that folds has no state ahead,
  /// and what is found is of another.
  T crossing = T(0.02);
  int corrections_per_step = 12;
  int most_iterations = 20000;  ///< of one advance, rejected steps included: a path that creeps has an end
};

/// Is what was found the state that was foretold? On a path that bends the prediction is off by part of its
/// step; what lies farther away than the whole step is on another branch, or the step was too long to tell.
/// @param off  rad, of the state found from the one foretold    @param foretold  rad, the step foretold
template <class T>
bool is_foretold(const T& off, const T& foretold, const SolverOptions<T>& options) {
  return off <= std::max(foretold, options.crossing);
}

/// From one load factor to another. Steps are halved when Newton fails or turns a joint too far, and doubled
/// after quick ones.
/// @param attempt  load factor -> NewtonRun<T>; NewtonStop::rounding says that the step was taken
/// @return  why it stopped before the end, if it did
template <class T, class Attempt>
std::optional<Status> in_load_steps(const T& start, const T& end, const SolverOptions<T>& options,
                                    const Attempt& attempt) {
  constexpr int kQuick = 6;  // corrections
  int iterations = 0;
  T done(0), step(1);
  while (done < T(1)) {
    step = std::min(step, T(T(1) - done));
    const T target = done + step;
    const NewtonRun<T> run = attempt(target < T(1) ? T(start + target * (end - start)) : end);
    iterations += run.corrections;
    if (run.stop == NewtonStop::rounding) {
      done = target;
      if (run.corrections <= kQuick) step *= T(2);
      continue;
    }
    step /= T(2);
    if (step < options.smallest_step || iterations > options.most_iterations)
      return run.stop == NewtonStop::not_finite ? Status::singular_tangent : Status::no_convergence;
  }
  return std::nullopt;
}

}  // namespace halfway
