// Along the load from none to all of it: what keeps shooting and collocation on the branch that grows from
// the rod without load.
#pragma once

#include "reference/truth/rod/rod.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace halfway::reference::rod {

/// How far two tips are apart: positions over the length, entries of R. NaN where one is no number.
double apart(const Tip& one, const Tip& other, double length);

/// The angle between two orientations, rad.
double turn_between(const Mat3<double>& one, const Mat3<double>& other);

/// From `point`, the rod without load, to the point at the factor 1 of the loads. A step that fails, or turns
/// the tip by more than 1 rad, is halved; one that succeeds is followed by one twice as long.
/// @param attempt  (factor, from) -> std::optional<Point>; a Point has the orientation `R` of its tip
template <class Point, class Attempt>
Point in_load_steps(const char* method, Point point, const Attempt& attempt) {
  constexpr double kFirst = 0.25, kSmallest = 1. / 4096, kLargestTurn = 1;
  double done = 0, step = kFirst;
  while (done < 1) {
    if (step < kSmallest)
      throw std::runtime_error(fmt::format("rod: {} came no further than {:.4g} of the loads", method, done));
    const double factor = std::min(1., done + step);
    const auto reached = attempt(factor, point);
    if (!reached || !(turn_between(reached->R, point.R) <= kLargestTurn)) {
      step /= 2;
      continue;
    }
    point = *reached;
    done = factor;
    step *= 2;
  }
  return point;
}

}  // namespace halfway::reference::rod
