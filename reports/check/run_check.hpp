// One program, asked and judged.
#pragma once

#include "reports/check/verdict.hpp"

#include <functional>

namespace halfway::check {

/// done, total, what: for a person who waits.
using Told = std::function<void(int, int, const std::string&)>;

/// @param as_bond  the joint points rest a metre apart along z
Verdict run_check(Program& program, bool as_bond, const Told& told);

/// Every question of a check in our convention, as lines: what a file of answers answers.
std::string all_questions(const Hello& hello, bool as_bond);

}  // namespace halfway::check
