// A joint by its name: the catalog's, a program's, or a wrong twin by some of its words.
#pragma once

#include "reference/programs/ask.hpp"

#include <string>

namespace halfway::check {

/// @param xi  of a formulation that has one. Throws reports::BadInput for a name that nobody has.
reference::Answerer known_joint(const std::string& name, double xi);

}  // namespace halfway::check
