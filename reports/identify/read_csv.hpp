// Curves in a text file: columns with units, a block for each load case.
#pragma once

#include "reference/identify/data.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace halfway::reports {

/// What was read, and what was assumed on the way, in words.
struct ReadCurves {
  reference::identify::Data data{};
  std::vector<std::string> notes{};
};

/// reports/identify/README.md has the format. Throws reference::Refusal with line and column of what is
/// wrong.
ReadCurves read_csv(std::string_view text);

}  // namespace halfway::reports
