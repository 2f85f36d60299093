// One line of text -> one JSON value, bounded in depth, with the id saved from lines that break off.
#pragma once

#include "reports/eval/eval_error.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>

namespace halfway::reports {

inline constexpr std::size_t kDeepestNesting = 32;

struct ParsedLine {
  nlohmann::json value;            ///< as far as it was read
  nlohmann::json id;               ///< the top-level "id", null when absent or unreadable
  std::optional<EvalError> error;  ///< malformed_json, too_deep, not_finite, empty_line, not_an_object
};

/// Never throws for what the line says; strict JSON, the last of duplicate keys counts.
ParsedLine parse_line(std::string_view line);

}  // namespace halfway::reports
