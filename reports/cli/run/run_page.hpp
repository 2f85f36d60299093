// The page of a run: one file, opens offline.
#pragma once

#include "reports/cli/run/page_data.hpp"

#include <span>

namespace halfway::reports {

std::string run_page(const Json& data);

/// The page up to its data, and on from there, in pieces, for compilers limit the length of a literal:
/// reports/page/run/embed.cmake writes what is declared here.
std::span<const std::string_view> page_before_data();
std::span<const std::string_view> page_after_data();

}  // namespace halfway::reports
