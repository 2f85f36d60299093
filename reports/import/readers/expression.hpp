// Arithmetic as MBDyn's input has it: numbers, names that were set, + - * / ^, parentheses, some functions.
#pragma once

#include "reports/import/record/text.hpp"

#include <map>

namespace halfway::imports {

using Variables = std::map<std::string, double, std::less<>>;

/// The value of a text; refused with its line where it is none.
double value_of(const Source& at, const Variables& variables);

}  // namespace halfway::imports
