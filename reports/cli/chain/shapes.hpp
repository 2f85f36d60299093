// Shapes of chains as text and as a drawing.
#pragma once

#include "reference/chain/scenes/solve_chain_scene.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

/// One row per node: formulation, xi (empty where it is not free), factor, s (arc length, m), x, y, z (m),
/// theta_x, theta_y, theta_z (rad): the rotation from the global axes, followed from the root so that it goes
/// on beyond pi. Numbers have 17 significant digits.
std::string shapes_csv(const reference::ChainScene& scene,
                       const std::vector<reference::ChainAnswer>& answers);

/// A self-contained SVG: the shapes seen along the global axes, to scale, in each plane in which they extend;
/// the last load factor full, the others faint.
std::string shapes_svg(const reference::ChainScene& scene,
                       const std::vector<reference::ChainAnswer>& answers);

}  // namespace halfway::reports
