// The record of plain Newton's basins: maps, shares, safe single steps, orders.
#pragma once

#include <nlohmann/json.hpp>

namespace halfway::reports {

/// `ends`: names of outcomes. `grids`: `name`, `axes` (1 to 3), `unit`, `largest`, `steps`, `angles`.
/// `tangents`: names. `maps`: `grid`, `formulation`, `tangent`, `share`, `safe_step`, `wrapped` (cells with a
/// step longer than pi) and `cells`, by angle, then magnitude: iterations + 64 times the index of the end.
/// `starts`: `formulation`, `moment` (N m), `resolution`, `has_branch`, `equilibria` (rotation vector, rad,
/// and number of cells; the continuous branch first) and `cells`: index of the equilibrium, -1 for none.
/// `orders`: `formulation`, `tangent`, `order`, `factor`, `predicted`, `iterations`; null where not
/// converged.
nlohmann::json stability_basins_record();

}  // namespace halfway::reports
