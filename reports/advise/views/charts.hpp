// The pictures of an advice, as SVG for its page: colours are the page's, by the attribute data-law.
#pragma once

#include "reports/advise/core/map.hpp"

#include <string>

namespace halfway::advise {

/// Cost against error, the tolerance as a line: what lies below it suffices, unless it is hollow.
std::string evidence_svg(const Advice& advice);

std::string map_svg(const Advice& advice, const std::vector<MapColumn>& columns);

/// ratio, from_deg, to_deg, advised ("" none); a row a piece.
std::string map_csv(const std::vector<MapColumn>& columns);

}  // namespace halfway::advise
