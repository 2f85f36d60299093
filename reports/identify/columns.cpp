#include "reports/identify/columns.hpp"

#include "reference/scene/text/dimensions.hpp"
#include "reference/scene/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace halfway::reports {
namespace {

namespace id = reference::identify;

/// Lower case, without blanks and underscores: Theta X, theta_x and thetaX are one.
std::string plain(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c != ' ' && c != '_' && c != '\t') out += char(std::tolower(static_cast<unsigned char>(c)));
  }
  return out;
}

reference::Dimension dimension_of(bool is_load, int component) {
  namespace dimension = reference::dimension;
  if (is_load) return component < 3 ? dimension::force : dimension::moment;
  return component < 3 ? dimension::length : dimension::angle;
}

}  // namespace

void refuse_at(int line, const std::string& key, const std::string& what, const std::string& allowed) {
  throw reference::Refusal("wrong_data", fmt::format("{}: {}; allowed: {}", key, what, allowed), key, line);
}

std::string_view trimmed_cell(std::string_view text) {
  const auto is_outer = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && is_outer(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_outer(text.back())) text.remove_suffix(1);
  return text;
}

std::string column_names() {
  std::string out;
  for (const auto* names : {&id::kLoadNames, &id::kMotionNames}) {
    for (const char* name : *names) out += (out.empty() ? "" : ", ") + std::string(name);
  }
  return out;
}

std::optional<Column> named_column(std::string_view name) {
  const std::string wanted = plain(name);
  for (int i = 0; i < 6; ++i) {
    if (wanted == plain(id::kLoadNames[std::size_t(i)]))
      return Column{true, i, {}, id::kLoadNames[std::size_t(i)]};
    if (wanted == plain(id::kMotionNames[std::size_t(i)]))
      return Column{false, i, {}, id::kMotionNames[std::size_t(i)]};
  }
  return std::nullopt;
}

reference::Unit read_component_unit(std::string_view text, bool is_load, int component,
                                    const std::string& key, int line) {
  const reference::Dimension needed = dimension_of(is_load, component);
  reference::Unit unit;
  try {
    unit = reference::read_unit(text);
  } catch (const reference::NoUnit& wrong) {
    refuse_at(line, key, wrong.what(), "a unit such as " + reference::example_units(needed));
  }
  if (!reference::fits(unit.dimension, needed))
    refuse_at(line, key, fmt::format("is in {}, which is no {}", text, reference::si_unit(needed)),
              "a unit such as " + reference::example_units(needed));
  return unit;
}

std::optional<Column> read_column(std::string_view head, int line) {
  const std::size_t open = head.find_first_of("[(");
  std::optional<Column> out = named_column(trimmed_cell(head.substr(0, open)));
  if (!out) return out;
  const std::string key = reference::shortened(std::string(head));
  if (open == std::string_view::npos)
    refuse_at(line, key, "has no unit",
              fmt::format("{} [{}] or another unit", out->name,
                          reference::si_unit(dimension_of(out->is_load, out->component))));
  const std::size_t close = head.find_last_of("])");
  if (close == std::string_view::npos || close < open)
    refuse_at(line, key, "its bracket is not closed", out->name + " [UNIT]");
  out->unit = read_component_unit(trimmed_cell(head.substr(open + 1, close - open - 1)), out->is_load,
                                  out->component, key, line);
  return out;
}

}  // namespace halfway::reports
