#include "reference/truth/fe/richardson.hpp"

#include <cmath>
#include <stdexcept>

namespace halfway::reference::fe {
namespace {

/// (coarse - middle) / (middle - fine) of a pure power of the level.
double change_ratio(const Sample& c, const Sample& m, const Sample& f, double p) {
  const auto power = [p](const Sample& s) { return std::pow(s.level, -p); };
  return (power(c) - power(m)) / (power(m) - power(f));
}

/// The order at which the ratio of the two changes is the one found; it grows with p.
double observed_order(const Sample& c, const Sample& m, const Sample& f) {
  const double ratio = (c.value - m.value) / (m.value - f.value);
  double low = 0.1, high = 12;
  if (!(ratio > change_ratio(c, m, f, low)) || !(ratio < change_ratio(c, m, f, high))) return 0;
  for (int i = 0; i < 60; ++i) {
    const double p = (low + high) / 2;
    (change_ratio(c, m, f, p) < ratio ? low : high) = p;
  }
  return low;
}

}  // namespace

Estimate richardson(const std::vector<Sample>& samples, double known_order) {
  if (samples.size() < 3) throw std::invalid_argument("an extrapolation needs three meshes");
  const Sample &c = samples[samples.size() - 3], &m = samples[samples.size() - 2], &f = samples.back();
  const double change = f.value - m.value;
  const double p = observed_order(c, m, f);
  if (!(p > 1 && p < 1.5 * known_order)) return {f.value, 3 * std::abs(change), p};
  const double correction = change / (std::pow(f.level / m.level, std::min(p, known_order)) - 1);
  return {f.value + correction, 1.25 * std::abs(correction), p};
}

}  // namespace halfway::reference::fe
