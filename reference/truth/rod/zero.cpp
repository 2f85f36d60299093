#include "reference/truth/rod/zero.hpp"

#include "reference/numbers/zeros.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace halfway::reference::rod {
namespace {

struct Point {
  Real50 distance, value;
};

Point point_of(const std::function<double(double)>& f, double x) {
  const double value = f(x);
  if (!std::isfinite(value)) throw std::runtime_error(fmt::format("rod: no number at {}", x));
  return {Real50(x), Real50(value)};
}

double narrowed(const std::function<double(double)>& f, Bracket<Point> bracket) {
  constexpr int kTimes = 60;  // a simple zero takes some ten
  double last = HUGE_VAL;
  for (int i = 0; i < kTimes && bracket.nearer_to_zero().value != Real50(0); ++i) {
    const auto x = double(bracket.guess());
    if (std::abs(x - last) <= std::numeric_limits<double>::epsilon() * std::abs(x)) break;
    bracket.narrow(point_of(f, last = x));
  }
  return double(bracket.nearer_to_zero().distance);
}

}  // namespace

double first_zero(const std::function<double(double)>& f, double low, double high, int samples) {
  Point left = point_of(f, low);
  for (int i = 1; i <= samples; ++i) {
    const Point right = point_of(f, low + (high - low) * i / samples);
    if (opposite(left.value, right.value)) return narrowed(f, {left, right});
    left = right;
  }
  throw std::runtime_error(fmt::format("rod: no change of sign between {} and {}", low, high));
}

}  // namespace halfway::reference::rod
