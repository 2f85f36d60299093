#include "reference/solve/path.hpp"

#include "reference/solve/free_directions.hpp"

namespace halfway::reference {

template <class T>
Path<T>::Path(const Scene& scene, const Entry& entry, double xi, const Setting& setting)
    : problem_(scene, entry, xi, setting), state_(problem_.initial(&held_reached_)) {
  if (has_play(scene)) play_.emplace(Play{scene, entry, xi, setting});
}

template <class T>
void Path<T>::leave_play(double factor) {
  const Scene soft = eased(play_->scene, factor);
  const EquilibriumProblem<T> problem(soft, play_->entry, play_->xi, play_->setting);
  const Outcome<T> near = problem.follow_to(problem.initial(), T(factor));
  const Outcome<T> found = problem_.equilibrium_near(near.joint, T(factor));
  const bool is_found = is_equilibrium(found.status);
  if (is_found)
    state_ = found;
  else
    state_.status = found.status;
  state_.iterations += near.iterations + (is_found ? 0 : found.iterations);
}

template <class T>
const Outcome<T>& Path<T>::advance(double factor) {
  if (held_reached_ < T(1)) return state_;
  if (play_ && state_.factor == T(0) && factor != 0) {
    leave_play(factor);
    return state_;
  }
  const int iterations = state_.iterations;
  state_ = problem_.follow_to(state_, T(factor));
  state_.iterations += iterations;
  return state_;
}

template class Path<double>;
template class Path<Real50>;

}  // namespace halfway::reference
