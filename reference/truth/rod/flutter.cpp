// A follower thrust does work around a loop: only motion tells whether the rod is stable under it.
#include "reference/truth/rod/critical.hpp"

#include <cmath>
#include <stdexcept>

namespace halfway::reference::rod {

Flutter follower_flutter(const Rod& rod, double mass_per_length, Flutter near) {
  constexpr int kPlane[] = {1, 5};
  const auto value = [&](double P, double frequency) {
    const Vec3<double> n(-P, 0, 0);
    const double inertia = mass_per_length * frequency * frequency;
    const Changes transfer = carried(rod, n, Vec3<double>::Zero(), inertia).changes;
    return determinant(clamped(), transfer, free_end(of_fixed_moment(), -skew(n)), kPlane);
  };
  return flutter(value, near);
}

Flutter flutter(const std::function<double(double, double)>& f, Flutter near) {
  // Frequencies meet where f has a double zero in the frequency: f = 0 and df = 0, by Newton. Differences of order 8:
  // with such a step their error is at rounding, because f is entire in the squares of the frequency.
  constexpr double kWeights[] = {4. / 5, -1. / 5, 4. / 105, -1. / 280};
  const double h = 0.02 * near.frequency, h_load = 1e-4 * near.load;
  const auto slope = [&](double load, double frequency) {
    double out = 0;
    for (int i = 0; i < 4; ++i)
      out += kWeights[i] * (f(load, frequency + (i + 1) * h) - f(load, frequency - (i + 1) * h));
    return out / h;
  };
  constexpr int kIterations = 30;
  for (int i = 0; i < kIterations; ++i) {
    const auto [P, w] = near;
    const double value = f(P, w), by_w = slope(P, w);
    const double by_P = (f(P + h_load, w) - f(P - h_load, w)) / (2 * h_load);
    const double by_wP = (slope(P + h_load, w) - slope(P - h_load, w)) / (2 * h_load);
    const double by_ww = (slope(P, w + h) - slope(P, w - h)) / (2 * h);
    const double determinant = by_P * by_ww - by_w * by_wP;
    const double dP = (by_w * by_w - value * by_ww) / determinant;
    const double dw = (value * by_wP - by_P * by_w) / determinant;
    near = {P + dP, w + dw};
    if (std::abs(dP / P) + std::abs(dw / w) < 1e-13) return near;
  }
  throw std::runtime_error("rod: no two frequencies meet near the load and the frequency given");
}

}  // namespace halfway::reference::rod
