// The page of an advice: one file, opens offline.
#pragma once

#include "reports/advise/core/map.hpp"

#include <string>

namespace halfway::advise {

/// @param command  that makes it again
std::string advice_page(const Advice& advice, const std::vector<MapColumn>& map, const std::string& command);

/// The report's styles and colours: reports/advise/page/embed.cmake writes what is declared here.
std::string_view page_style();
std::string_view page_script();

}  // namespace halfway::advise
