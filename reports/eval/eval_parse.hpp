// One line of text -> one tree, bounded in depth and size, with the id saved from lines that break off.
#pragma once

#include "reports/eval/line_tree.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace halfway::reports {

struct ParsedLine {
  reference::Document document;  ///< as far as it was read
  std::string id = "null";       ///< the top-level "id" as it came, null when absent or unreadable: JSON
  /// malformed_json, too_deep, too_many_values, duplicate_key, not_finite, empty_line, not_an_object
  std::optional<reference::Refusal> error{};
};

/// Never throws for what the line says; strict JSON.
/// @return  its texts are good until the thread parses its next line
ParsedLine parse_line(std::string_view line);

}  // namespace halfway::reports
