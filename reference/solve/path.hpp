// One formulation on its way through one scene, in double or at 50 digits.
#pragma once

#include "reference/solve/equilibrium_problem.hpp"

#include <optional>
#include <string>

namespace halfway::reference {

/// The equilibrium path of a scene, from load factor 0 on, see EquilibriumProblem::initial. T is double or
/// Real50.
template <class T>
class Path {
 public:
  /// References must outlive the path. @param xi  for a formulation that has one.
  Path(const Scene& scene, const Entry& entry, double xi, const Setting& setting = {});

  /// Goes on to a load factor; the state is the last equilibrium reached, converged or not.
  const Outcome<T>& advance(double factor);

  const Outcome<T>& state() const { return state_; }
  /// How far the way to load factor 0 came, on which held loads are put on: 1 is there.
  const T& held_reached() const { return held_reached_; }

  /// As of EquilibriumProblem, for the state.
  T output(const std::string& name) const { return problem_.output(name, state_.joint); }
  T output_error(const std::string& name) const { return problem_.output_error(name, state_); }
  Pose<T> node() const { return problem_.node(state_.joint); }
  const EquilibriumProblem<T>& problem() const { return problem_; }
  T linear_output(const std::string& name, double factor) const {
    return problem_.linear_output(name, T(factor));
  }

 private:
  /// Of a scene with play, see has_play(): what its first equilibrium is found with.
  struct Play {
    Scene scene;
    const Entry& entry;
    double xi;
    Setting setting;
  };
  void leave_play(double factor);

  EquilibriumProblem<T> problem_;
  std::optional<Play> play_{};
  T held_reached_{1};
  Outcome<T> state_;
};

}  // namespace halfway::reference
