// Check x saboteur: each check has to see what it claims to judge.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/saboteurs/trial.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::verify {

/// One check, which speaks for those of its sort, and the saboteurs that it met.
struct Row {
  std::string check, room;
  std::size_t siblings = 1;           ///< how many checks are of its sort, with itself
  Parts seen{};                       ///< what it asks for, by a witness
  std::vector<std::string> caught{};  ///< saboteurs that made it fail, and mutants of its measurement
  std::vector<std::string> wrong{};   ///< what is wrong with the check, empty of a sound one
  std::string left_out{};             ///< why it met none, where all of its sort are left out
};

/// How many sorts of checks, in every how many-th row, and the CPU seconds that one run may take.
struct Sampling {
  int every = 1;
  int limit = 20;
};

/// A row for each sort of the checks that `make` registers, which is called anew with each saboteur in use. A
/// check that asks a formulation for nothing and passes no tap needs a mutant of its own (claims.hpp).
std::vector<Row> matrix(const std::function<Checks()>& make, const Sampling& sampling);

/// The finding "saboteurs/<check>" of a row: how much is wrong with the check, and what caught it.
Finding finding_of(const Row& row);

/// The rows of one room of checks.def, computed once.
const std::vector<Row>& rows_of_room(const std::string& room);

/// All rows that were computed in this process.
std::vector<Row> computed_rows();

}  // namespace halfway::verify
