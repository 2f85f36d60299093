// One program, asked and judged.
#pragma once

#include "reports/check/judge/verdict.hpp"

#include <functional>

namespace halfway::check {

/// done, total, what: for a person who waits.
using Told = std::function<void(int, int, const std::string&)>;

/// @param as_bond  the joint points rest a metre apart along z
Verdict run_check(Program& program, bool as_bond, const Told& told);

/// Every question of a check in our convention, a line each; with a joint, its loads beside them: vectors for
/// the tests of others. As JSON lines, described by questions.schema.json, or as a table with a header of
/// columns.
std::string questions_as_lines(const Hello& hello, bool as_bond, const Answerer& joint);
std::string questions_as_table(const Hello& hello, bool as_bond, const Answerer& joint);

}  // namespace halfway::check
