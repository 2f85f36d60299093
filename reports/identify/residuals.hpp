// What the fits leave of the measured numbers, drawn.
#pragma once

#include "reports/identify/results.hpp"

namespace halfway::reports {

/// A panel for each measured component, rows of all cases one after the other: measured less answered, by the
/// stage that is shown and by the joint of the scene.
std::string residuals_svg(const Identified& what);

}  // namespace halfway::reports
