// The curves of one scene as a chart.
#pragma once

#include "reference/solve/solve.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

/// A self-contained SVG: one panel per output over the load factor, one polyline per curve, axes with
/// ticks and units, one legend.
std::string curves_svg(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves);

/// What the legend calls each.
std::vector<std::string> legend_of(const std::vector<reference::Curve>& curves);

}  // namespace halfway::reports
