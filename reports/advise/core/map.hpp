// The adequacy map: rotation times stiffness ratio -> the cheapest law that suffices.
#pragma once

#include "reports/advise/core/advice.hpp"

namespace halfway::advise {

/// Up to `to` rad the candidate of that name is the cheapest that is within the tolerance, and nothing
/// against it; "" none.
struct MapPiece {
  double to = 0;
  std::string name{}, formulation{};
};

/// Of one stiffness ratio, ascending; the last ends where the truth does, or at a third of a turn.
struct MapColumn {
  double ratio = 1;
  std::vector<MapPiece> pieces{};
};

/// Of truths that can be made at another ratio (has_other_ratios); empty for others. The direction of the
/// load, the axes of the law and the tolerance are the question's.
std::vector<MapColumn> adequacy_map(const Advice& advice, const std::map<std::string, Cost>& costs);

inline constexpr double kMapLeast = 1e-3;  ///< rad, where the map begins

}  // namespace halfway::advise
