// One line of text -> one tree, bounded in depth and size, with the id saved from lines that break off. A
// parser of our own: nlohmann's took two thirds of a request's time.
#pragma once

#include "reference/scene/document.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace halfway::reports {

inline constexpr std::size_t kMostValues = 1000000;  ///< of one line; a pose has 21

struct ParsedLine {
  reference::Document document;  ///< as far as it was read; its texts are the line's own
  std::string id = "null";       ///< the top-level "id" as it came, null when absent or unreadable: JSON
  /// malformed_json, too_deep, too_many_values, duplicate_key, not_finite, empty_line, not_an_object
  std::optional<reference::Refusal> error{};
};

/// Never throws for what the line says; strict JSON.
/// @param line  has to outlive what is returned
ParsedLine parse_line(std::string_view line);

}  // namespace halfway::reports
