// Sorts of checks: those whose names differ by a formulation, a body or a number alone run the same
// code.
#pragma once

#include "verify/check.hpp"

#include <string>
#include <vector>

namespace halfway::verify {

/// The name with * for what varies: */angular/tangent, fe/kept/*.
std::string sort_of(const std::string& check);

/// The checks of one sort.
struct Siblings {
  std::string sort;
  std::vector<std::size_t> members;  ///< places in the list of all; the one that speaks best for it first
};

/// In the order of the first of each sort.
std::vector<Siblings> sorted(const Checks& checks);

}  // namespace halfway::verify
