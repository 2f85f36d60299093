// A straight rod under a torque: both lateral directions as one complex number.
#include "reference/truth/rod/critical.hpp"

#include <array>
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

Complex torque_determinant(const Rod& rod, TorqueEnds ends, double M, double P) {
  const Vec3<double> m(M, 0, 0);
  const Pair pair = ends_of(ends, m);
  const Eigen::Matrix<double, 6, 6> all =
      pair.end.demanded * (carried(rod, {-P, 0, 0}, m).changes * pair.start.admitted);
  // What turns with the rod about its axis commutes with i: columns 2 and 5 alone tell it.
  const auto entry = [&](int i, int j) { return Complex(all(i, j), all(i + 1, j)); };
  return entry(1, 1) * entry(4, 4) - entry(1, 4) * entry(4, 1);
}

double critical_torque(const Rod& rod, TorqueEnds ends, double P, double low, double high) {
  const auto f = [&](double M) { return torque_determinant(rod, ends, M, P); };
  constexpr int kSamples = 24;
  const double step = (high - low) / kSamples;
  // Gauss and Newton from the sample before which |f| falls and after which it rises; what it stops at is a
  // zero if f is nothing there beside what it was.
  for (int i = 1; i < kSamples; ++i) {
    double M = low + i * step;
    const double before = std::abs(f(M - step)), here = std::abs(f(M)), after = std::abs(f(M + step));
    if (here > before || here > after) continue;
    for (int k = 0; k < 8; ++k) {
      const double h = 1e-5 * step;
      const Complex value = f(M), slope = (f(M + h) - f(M - h)) / (2 * h);
      M -= std::real(std::conj(slope) * value) / std::norm(slope);
    }
    if (std::abs(f(M)) < 1e-10 * before) return M;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace halfway::reference::rod
