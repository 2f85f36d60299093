// Check x saboteur: each check has to see what it claims to judge.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/saboteurs/trial.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::verify {

/// One check and the saboteurs that it met.
struct Row {
  std::string check, room;
  Parts seen{};                       ///< what it asks for, by a witness
  std::vector<std::string> caught{};  ///< saboteurs that made it fail
  std::vector<std::string> wrong{};   ///< what is wrong with the check, empty of a sound one
};

/// How many of the checks, in every how many-th row, and the CPU seconds that one run may take.
struct Sampling {
  int every = 1;
  int limit = 20;
};

/// The rows of the checks that `make` registers, but of those that are left out: it is called anew with each
/// saboteur in use. A check that asks a formulation for nothing has no row but that of its mutant
/// (mutant_of).
std::vector<Row> matrix(const std::function<Checks()>& make, const Sampling& sampling);

/// The finding "saboteurs/<check>" of a row: how much is wrong with the check, and what caught it.
Finding finding_of(const Row& row);

/// The rows of one room of checks.def for a few formulations, computed once.
const std::vector<Row>& rows_of_room(const std::string& room);

/// All rows that were computed in this process.
std::vector<Row> computed_rows();

}  // namespace halfway::verify
