// The one Newton: when to go on, when to stop, and what is then known. A system brings its own algebra.
//
// A system has look(), which evaluates the equations at its present state and solves for the correction,
// and move(), which applies the correction that look() found.
#pragma once

#include <cmath>
#include <utility>

namespace halfway {

/// What the equations say at the present state.
template <class T>
struct NewtonLook {
  T size;            ///< of the correction, one unit for all its directions; not finite where there is none
  bool is_rounding;  ///< the imbalance is what rounding leaves, in each direction by its own measure
  bool may_be_rounding = false;  ///< or what it may leave at most: enough where corrections shrink no more
};

enum class NewtonStop {
  rounding,    ///< the imbalance is rounding
  stalled,     ///< the corrections stopped shrinking before: rounding not accounted for, or no root
  not_finite,  ///< no correction: a singular tangent, or loads that are no numbers
  too_many_corrections
};

template <class T>
struct NewtonRun {
  NewtonStop stop;
  int corrections;  ///< that were applied
  T first{0};       ///< size of the first
  T second{0};      ///< and of the second: how fast it converges
};

/// A small correction proves nothing, a small imbalance in a stiff direction neither: what ends it well is an
/// imbalance that is rounding in every direction, seen at the state that is returned. In a narrow valley
/// (stiff axes that turn with the motion) one correction follows the floor and the next returns to it: they
/// have to shrink over two.
/// @param free  corrections that may grow: the first ones lead from afar
template <class T, class System>
NewtonRun<T> newton(System& system, int most_corrections, int free = 1) {
  using std::isfinite;
  NewtonRun<T> run{NewtonStop::too_many_corrections, 0};
  for (T previous(0), earlier(0);; ++run.corrections) {
    const NewtonLook<T> look = system.look();
    if (run.corrections == 0) run.first = look.size;
    if (run.corrections == 1) run.second = look.size;
    if (!isfinite(look.size))
      run.stop = NewtonStop::not_finite;
    else if (look.is_rounding)
      run.stop = NewtonStop::rounding;
    else if (run.corrections > free && !(look.size < previous) && !(look.size < earlier))
      run.stop = look.may_be_rounding ? NewtonStop::rounding : NewtonStop::stalled;
    else if (run.corrections < most_corrections) {
      system.move();
      earlier = std::exchange(previous, look.size);
      continue;
    }
    return run;
  }
}

}  // namespace halfway
