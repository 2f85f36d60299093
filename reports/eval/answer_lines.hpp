// Answers of many lines, shared out among threads.
#pragma once

#include "reports/eval/input_lines.hpp"

#include <span>
#include <string>

namespace halfway::reports {

inline constexpr std::size_t kLongestLine = std::size_t(16) << 20;  ///< bytes; a pose needs some hundreds

/// One answer a line, each with its end, in the order of the lines; the same for any number of threads.
/// @param threads  at most so many; few bytes are not worth one
std::string answered(std::span<const InputLines::Line> lines, int threads);

}  // namespace halfway::reports
