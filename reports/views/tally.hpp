// Findings counted and looked up, for the summaries.
#pragma once

#include "reports/views/results.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

struct Tally {
  int pass = 0, fail = 0, known_failure = 0, left_out = 0;
  int total() const { return pass + fail + known_failure + left_out; }
};

Tally tally(const std::vector<reference::Finding>& findings);

/// The finding of that name, or nullptr.
const reference::Finding* find_finding(const Results& results, const std::string& name);

/// The timing of a formulation and kind: of its plain kernel, of its transcription where there is none, or
/// nullptr.
const bench::Timing* find_timing(const Results& results, const std::string& formulation,
                                 const std::string& kind, const std::string& what);

/// One line for people: the value with its unit, and what it was held against.
std::string explain(const reference::Finding& finding);

}  // namespace halfway::reports
