// Bracketing: the one way in which the house narrows down where something changes.
#pragma once

#include "reference/numbers/precision.hpp"

#include <utility>

namespace halfway::reference {

/// Where something changes between `low`, at which `holds`, and `high`, at which it does not; by halves.
/// @param times  each gives a bit. @return the last point at which it holds
template <class T, class Holds>
T last_where(const Holds& holds, T low, T high, int times) {
  for (int i = 0; i < times; ++i) {
    const T middle = (low + high) / T(2);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

inline bool opposite(const Real50& a, const Real50& b) { return (a < Real50(0)) != (b < Real50(0)); }

/// Two points whose values have other signs. False position with Illinois' weights keeps that and converges
/// faster than linearly. Point has `distance` and `value`, both Real50.
template <class Point>
class Bracket {
 public:
  Bracket(Point one, Point other) : low_(std::move(one)), high_(std::move(other)) {}

  Real50 guess() const {
    const Real50 a = low_weight_ * low_.value, b = high_weight_ * high_.value;
    return (low_.distance * b - high_.distance * a) / (b - a);
  }
  const Point& nearer(const Real50& distance) const {
    return abs(distance - low_.distance) < abs(distance - high_.distance) ? low_ : high_;
  }
  void narrow(const Point& point) {
    const bool replaces_low = !opposite(point.value, low_.value);
    (replaces_low ? low_ : high_) = point;
    (replaces_low ? low_weight_ : high_weight_) = Real50(1);
    if (replaced_before_ && replaces_low == replaced_low_)
      (replaces_low ? high_weight_ : low_weight_) *= Real50(0.5);
    replaced_low_ = replaces_low;
    replaced_before_ = true;
  }
  const Point& nearer_to_zero() const { return abs(low_.value) < abs(high_.value) ? low_ : high_; }
  const Point& low() const { return low_; }
  const Point& high() const { return high_; }

 private:
  Point low_, high_;
  Real50 low_weight_{1}, high_weight_{1};
  bool replaced_low_ = false, replaced_before_ = false;
};

}  // namespace halfway::reference
