// Mesh convergence: the extrapolated value and what it may be wrong by.
#pragma once

#include <vector>

namespace halfway::reference::fe {

struct Estimate {
  double value = 0;
  double uncertainty = 0;  ///< half width of the error bar, same unit
  double order = 0;        ///< observed order of convergence in 1/level; 0: none could be observed
};

/// What one mesh gave.
struct Sample {
  double level;  ///< elements along one edge: all divisions scale with it
  double value;
};

/// Order of energies and compliances on meshes graded with exponent 3 toward the singular edges (energy
/// rate 1.42 on uniform meshes): min(4, 3 x 1.42), the quadratic element's own.
inline constexpr double kGradedOrder = 4;

/// Fits v + c level^-p to the last three samples (ascending levels) and extrapolates with the observed p,
/// not above known_order. The error bar is the grid convergence index: 1.25 of the finest mesh's distance
/// from the extrapolated value where an order in (1, 1.5 known_order) is observed; else 3 times the last
/// change. Throws std::invalid_argument for fewer than three samples.
Estimate richardson(const std::vector<Sample>& samples, double known_order = kGradedOrder);

}  // namespace halfway::reference::fe
