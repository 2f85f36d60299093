// What an unknown name may have meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

/// " (did you mean 'X'?)" of the allowed name that is most like `name`: up to a third of its letters
/// mistyped, or cut short. Empty when none is like it.
std::string did_you_mean(std::string_view name, const std::vector<std::string_view>& allowed);

/// "unknown WHAT 'NAME' (did you mean 'X'?); allowed: A, B, C". Long names are cut.
std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string_view>& allowed);

}  // namespace halfway::reference
