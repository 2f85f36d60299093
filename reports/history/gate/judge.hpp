// From times to lines.
#pragma once

#include "reports/history/gate/line.hpp"
#include "reports/history/gate/times.hpp"

#include <optional>

namespace halfway::gate {

/// Instructions of a figure on one side, asked only for what is slower.
using Instructions = std::function<std::optional<double>(const Side&, const std::string& figure)>;

/// Slower in both rounds: a regression. Faster in the first: an improvement. Not measured by head: a
/// regression. Errors of what was timed, where the programs tell them: by digits. Throws reports::FailedRun
/// where no figure was measured on both sides.
Outcome judge(const Measured& measured, const Side& base, const Side& head, const TimeRules& rules,
              const Instructions& instructions);

}  // namespace halfway::gate
