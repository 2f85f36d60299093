// A straight rod under a torque: both lateral directions as one complex number.
#include "reference/truth/rod/critical.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace halfway::reference::rod {
namespace {

using Complex = std::complex<double>;

struct Pair {
  End start, end;
};

Pair ends_of(TorqueEnds ends, const Vec3<double>& m) {
  const Mat3<double> fixed = of_fixed_moment(), follower = of_follower_moment(m);
  switch (ends) {
    case TorqueEnds::hinged_fixed:
      return {hinged(fixed), hinged(fixed)};
    case TorqueEnds::hinged_follower:
      return {hinged(follower), hinged(follower)};
    case TorqueEnds::clamped:
      return {clamped(), clamped()};
    case TorqueEnds::clamped_hinged_fixed:
      return {clamped(), hinged(fixed)};
    case TorqueEnds::clamped_hinged_follower:
      return {clamped(), hinged(follower)};
    case TorqueEnds::clamped_free_fixed:
      return {clamped(), free_end(fixed)};
    case TorqueEnds::clamped_free_follower:
      return {clamped(), free_end(follower)};
  }
  throw std::invalid_argument("rod: no such ends");
}

}  // namespace

Complex torque_determinant(const Rod& rod, TorqueEnds ends, double M, double P, int finer) {
  const Vec3<double> m(M, 0, 0);
  const Pair pair = ends_of(ends, m);
  const Eigen::Matrix<double, 6, 6> all =
      pair.end.demanded * (carried(rod, {-P, 0, 0}, m, finer).changes * pair.start.admitted);
  // What turns with the rod about its axis commutes with i: columns 2 and 5 alone tell it.
  const auto entry = [&](int i, int j) { return Complex(all(i, j), all(i + 1, j)); };
  return entry(1, 1) * entry(4, 4) - entry(1, 4) * entry(4, 1);
}

namespace {

/// From near a zero of f by Gauss and Newton, with which |f| falls to rounding where there is one.
double minimum(const std::function<Complex(double)>& f, double M, double h) {
  constexpr int kTimes = 12;
  for (int i = 0; i < kTimes; ++i) {
    const Complex slope = (f(M + h) - f(M - h)) / (2 * h);
    const double step = std::real(std::conj(slope) * f(M)) / std::norm(slope);
    M -= step;
    if (std::abs(step) < 1e-14 * M) break;
  }
  return M;
}

}  // namespace

Critical critical_torque(const Rod& rod, TorqueEnds ends, double P, double low, double high) {
  const auto with = [&](int finer) {
    return [&, finer](double M) { return torque_determinant(rod, ends, M, P, finer); };
  };
  const auto f = with(kFiner);
  constexpr int kSamples = 12;
  constexpr double kNothing = 1e-10;  // of |f| a sample away: rounding leaves 1e-14
  const double step = (high - low) / kSamples;
  double before = std::abs(f(low)), here = std::abs(f(low + step));
  for (int i = 2; i <= kSamples; ++i) {
    const double after = std::abs(f(low + i * step));
    if (here <= before && here <= after) {
      const double M = minimum(f, low + (i - 1) * step, 1e-4 * step);
      const bool is_zero = std::abs(f(M)) < kNothing * before;
      if (is_zero) return {M, std::abs(M - minimum(with(1), M, 1e-4 * step))};
    }
    before = here;
    here = after;
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  return {none, none};
}

}  // namespace halfway::reference::rod
