// What a check found, whole, and the forms that people and machines read.
#pragma once

#include "reports/check/judge/examine.hpp"

#include <string>
#include <vector>

namespace halfway::check {

struct Verdict {
  Hello hello;
  reference::Identity identity;
  bool is_known = false;        ///< the nearest joint answers the same to the program's digits
  reference::FamilyFit family;  ///< where nobody known is it
  std::vector<Result> results;
  std::size_t asked = 0, answered = 0, skipped = 0;
  std::vector<std::string> lost;  ///< "id: why", of questions without an answer
  std::vector<std::string> remarks;
  std::string repeat;  ///< the command of the whole check

  /// Something failed that nobody expected, an answer was lost, or something passed that was expected to
  /// fail.
  bool fails() const;
};

/// Statuses by a file of expected failures: ids or groups/*, # begins a comment. Throws reports::BadInput for
/// an id that no result has.
void expect(Verdict& verdict, const std::string& file);

std::string as_text(const Verdict& verdict);
std::string as_markdown(const Verdict& verdict);
std::string as_junit(const Verdict& verdict);
/// A badge of shields.io's endpoint schema.
std::string as_badge(const Verdict& verdict);
/// Lines that ctest takes as measurements of the test that prints them.
std::string as_ctest(const Verdict& verdict);

/// Each failure as a file in `folder`: the smallest question that has it, both answers, the equation, a
/// command.
/// @param program  is asked again where it runs, to make questions smaller
/// @return  the names of the files
std::vector<std::string> write_failures(const Verdict& verdict, const std::string& folder, Program& program);

}  // namespace halfway::check
