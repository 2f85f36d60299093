// What every refusal of a file keeps.
#pragma once

#include "reference/scene/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

namespace halfway::reports::test {

/// Empty, or the promise that is broken: one message, not endless, that names a line of the text.
inline std::string broken_by(const reference::Refusal& refusal, std::string_view text) {
  const std::string said = refusal.what();
  if (said.empty() || said.size() > 2000) return fmt::format("a refusal of {} bytes", said.size());
  const auto lines = 1 + std::ranges::count(text, '\n');
  if (refusal.line < 1 || refusal.line > lines)
    return fmt::format("line {} of {}: {}", refusal.line, lines, said);
  return "";
}

}  // namespace halfway::reports::test
