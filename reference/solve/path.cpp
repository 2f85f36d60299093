#include "reference/solve/path.hpp"

namespace halfway::reference {

template <class T>
Path<T>::Path(const Scene& scene, const Entry& entry, double xi, const Setting& setting)
    : problem_(scene, entry, xi, setting), state_(problem_.initial(&held_reached_)) {}

template <class T>
const Outcome<T>& Path<T>::advance(double factor) {
  if (held_reached_ < T(1)) return state_;
  const int iterations = state_.iterations;
  state_ = problem_.follow_to(state_, T(factor));
  state_.iterations += iterations;
  return state_;
}

template class Path<double>;
template class Path<Real50>;

}  // namespace halfway::reference
