#include "reference/truth/rod/closed/loads.hpp"

#include "reference/numbers/zeros.hpp"

#include <cmath>
#include <complex>
#include <numbers>
#include <stdexcept>

namespace halfway::reference::rod::closed {
namespace {

constexpr double kPi = std::numbers::pi;

struct Point {
  Real50 distance, value;
};

/// Of a function at 50 digits with one change of sign between.
template <class F>
double zero_between(const F& f, double low, double high) {
  const auto at = [&](const Real50& x) { return Point{x, f(x)}; };
  Bracket<Point> bracket(at(Real50(low)), at(Real50(high)));
  constexpr int kTimes = 12;  // leaves some 1e-30
  for (int i = 0; i < kTimes; ++i) bracket.narrow(at(bracket.guess()));
  return double(bracket.nearer_to_zero().distance);
}

/// J_{-1/4}(x) (x/2)^{1/4} Gamma(3/4): sum of (-x^2/4)^k/(k! (3/4) (7/4) ...).
Real50 bessel_minus_quarter(const Real50& x) {
  Real50 term(1), sum(1);
  for (int k = 0; k < 40; ++k) {
    term *= -x * x / Real50(4) / (Real50(k + 1) * Real50(k + 0.75));
    sum += term;
  }
  return sum;
}

}  // namespace

double greenhill_hinged(double B, double length, double P) {
  return 2 * B * std::sqrt(kPi * kPi / (length * length) - P / B);
}

double greenhill_clamped(double B, double length) {
  return 2 * B / length * zero_between([](const Real50& z) { return sin(z) - z * cos(z); }, 4, 5);
}

double torque_determinant(TorqueEnds ends, double M) {
  using namespace std::complex_literals;
  const std::complex<double> turn = std::exp(1i * M);
  const double cube = M * M * M;
  switch (ends) {
    case TorqueEnds::clamped_hinged_follower:
      return std::abs((1. + 1i * M) - (1 + M * M / 2) * turn) / cube;
    case TorqueEnds::clamped_hinged_fixed:
      return std::abs((1 + M * M / 2) - (1. - 1i * M) * turn) / cube;
    case TorqueEnds::clamped_free_fixed:
    case TorqueEnds::clamped_free_follower:
      return 1;
    default:
      throw std::invalid_argument("rod: these ends let a torque buckle it");
  }
}

double semi_tangential(double B, double length) { return kPi * B / length; }
double quasi_tangential(double B, double length) { return kPi / 2 * B / length; }

double fork_strip(const Vec3<double>& k, double length) {
  return kPi / length * std::sqrt(k[0] * k[1] / ((1 - k[1] / k[2]) * (1 - k[0] / k[2])));
}

double tip_force(double EI2, double GJ, double length) {
  return 2 * zero_between(bessel_minus_quarter, 1.9, 2.1) * std::sqrt(EI2 * GJ) / (length * length);
}

double beck_determinant(double P, double w) {
  const double r = std::sqrt(P * P / 4 + w * w), a = std::sqrt(r - P / 2), b = std::sqrt(r + P / 2);
  return P * P + 2 * w * w * (1 + std::cosh(a) * std::cos(b)) + P * w * std::sinh(a) * std::sin(b);
}

}  // namespace halfway::reference::rod::closed
