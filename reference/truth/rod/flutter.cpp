// A follower thrust does work around a loop: only motion tells whether the rod is stable under it.
#include "reference/record/worst.hpp"
#include "reference/truth/rod/critical.hpp"

#include <cmath>
#include <stdexcept>

namespace halfway::reference::rod {

Flutter follower_flutter(const Rod& rod, double mass_per_length, Flutter near) {
  constexpr int kPlane[] = {1, 5};
  const auto value = [&](int finer) {
    return [&, finer](double P, double frequency) {
      const Vec3<double> n(-P, 0, 0);
      const double inertia = mass_per_length * frequency * frequency;
      const Changes transfer = carried(rod, n, Vec3<double>::Zero(), finer, inertia).changes;
      return determinant(clamped(), transfer, free_end(of_fixed_moment(), -skew(n)), kPlane);
    };
  };
  Flutter out = flutter(value(kFiner), near);
  const Flutter coarse = flutter(value(1), out);
  out.error = larger(std::abs(coarse.load / out.load - 1), std::abs(coarse.frequency / out.frequency - 1));
  return out;
}

namespace {

/// df/dw by differences of order 8: with such steps their error is at rounding, f being entire in w^2.
double slope(const std::function<double(double, double)>& f, const Flutter& at, double h) {
  constexpr double kWeights[] = {4. / 5, -1. / 5, 4. / 105, -1. / 280};
  double out = 0;
  for (int i = 0; i < 4; ++i) {
    const double step = (i + 1) * h;
    out += kWeights[i] * (f(at.load, at.frequency + step) - f(at.load, at.frequency - step));
  }
  return out / h;
}

}  // namespace

Flutter flutter(const std::function<double(double, double)>& f, Flutter near) {
  // Frequencies meet where f has a double zero in w: f = 0 and df/dw = 0, by Newton. Its matrix is good to
  // some three digits, which is how many an iteration adds.
  constexpr int kTimes = 30;
  for (int i = 0; i < kTimes; ++i) {
    const double P = near.load, w = near.frequency;
    const double h = 0.02 * w, h_P = 0.01 * P;
    const double here = f(P, w), by_w = slope(f, near, h);
    const double by_P = (f(P + h_P, w) - f(P - h_P, w)) / (2 * h_P);
    const double by_ww = (f(P, w + h) - 2 * here + f(P, w - h)) / (h * h);
    const double by_wP =
        (f(P + h_P, w + h) - f(P + h_P, w - h) - f(P - h_P, w + h) + f(P - h_P, w - h)) / (4 * h_P * h);
    const double determinant_of_both = by_P * by_ww - by_w * by_wP;
    const double dP = (by_w * by_w - here * by_ww) / determinant_of_both;
    const double dw = (here * by_wP - by_P * by_w) / determinant_of_both;
    near = {.load = P + dP, .frequency = w + dw};
    if (std::abs(dP / P) + std::abs(dw / w) < 1e-13) return near;
  }
  throw std::runtime_error("rod: no two frequencies meet near the load and the frequency given");
}

}  // namespace halfway::reference::rod
