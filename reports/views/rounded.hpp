// Numbers as a chart needs them: fewer digits, a smaller page.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <vector>

namespace halfway::reports {

/// To `digits` significant ones. What is not finite stays, and becomes null in JSON.
inline double rounded(double x, int digits) {
  return std::isfinite(x) ? std::strtod(fmt::format("{:.{}e}", x, digits - 1).c_str(), nullptr) : x;
}

inline std::vector<double> rounded(std::vector<double> values, int digits) {
  for (double& x : values) x = rounded(x, digits);
  return values;
}

}  // namespace halfway::reports
