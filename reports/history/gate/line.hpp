// What a comparison found, one line each, and the forms in which a terminal, a pull request and a CI read
// them.
#pragma once

#include "reports/history/statistics/exact.hpp"

#include <string>
#include <vector>

namespace halfway::gate {

using statistics::Sense;

struct Line {
  Sense sense = Sense::change;
  std::string figure;
  std::string text;  ///< what, how much, since which commit, how sure
};

struct Outcome {
  std::string title;  ///< what was compared
  std::vector<Line> lines{};
  std::vector<std::string> notes{};  ///< what a reader has to know to judge the lines
  int compared = 0;                  ///< figures on both sides
  int count(Sense sense) const;
};

/// Regressions, then improvements, then how many merely changed (`all`: each of them); a summary last.
std::string as_text(const Outcome& outcome, bool all);
std::string as_markdown(const Outcome& outcome);

enum class Service { none, github, gitlab, azure };
/// By name; "auto": the one whose environment this is. Throws reports::BadInput.
Service service_of(const std::string& name);
/// Lines that the service reads from the output; empty where it reads none.
std::string annotations(const Outcome& outcome, Service service);
/// GitLab's code quality report.
std::string code_quality(const Outcome& outcome);

}  // namespace halfway::gate
