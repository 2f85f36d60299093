// What checks do not claim to see, and what mutants claim to show. Without a line here a check has to fail
// for everything that it asks for.
#pragma once

#include "verify/oracle/saboteurs/saboteur.hpp"

#include <span>
#include <string>
#include <vector>

namespace halfway::verify {

/// What a check asks for and does not judge.
Parts overlooked(const std::string& check);

/// A check of a wrong twin, and the sort of checks whose measurement it makes.
struct Shown {
  std::string_view sort;
  std::string_view mutant;
};
std::span<const Shown> shown_by_mutants();

/// The mutants that show a sort of checks able to fail.
std::vector<std::string> mutants_of(const std::string& sort);

}  // namespace halfway::verify
