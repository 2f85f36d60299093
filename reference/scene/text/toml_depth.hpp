// Dotted keys nest as deeply as they are long, and toml++ limits arrays and inline tables alone.
#pragma once

#include <string_view>

namespace halfway::reference {

/// The first line with a key of more than kDeepestNesting names, such as a.b.c; 0: none. Looks at text
/// outside of strings and comments, whether it is TOML or not.
int line_of_deep_key(std::string_view text);

}  // namespace halfway::reference
