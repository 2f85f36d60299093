// Unknown names answered with what is allowed.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfway::reports {

/// The name nearest to `name` by edit distance; empty when `allowed` is.
std::string_view closest(std::string_view name, const std::vector<std::string_view>& allowed);

/// "unknown WHAT 'NAME', did you mean 'X'? allowed: A, B, C". Names longer than 60 bytes are cut.
std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& allowed);

/// Names of all formulations of the catalog, in its order.
std::vector<std::string_view> formulation_names();

}  // namespace halfway::reports
