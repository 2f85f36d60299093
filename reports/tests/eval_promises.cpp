#include "reports/tests/eval_promises.hpp"

#include "reports/eval/eval_line.hpp"
#include "reports/eval/eval_parse.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <bit>

namespace halfway::reports::test {
namespace {

using nlohmann::ordered_json;
using reference::Document;
using Type = reference::DocumentNode::Type;

bool is_same(const Document& document, std::size_t place, const ordered_json& value);

/// Members in the order of the text; nlohmann keeps one of two that have the same name, which is refused
/// here.
bool are_items_same(const Document& document, std::size_t place, const ordered_json& value) {
  std::size_t item = place + 1, count = 0;
  for (const auto& [key, expected] : value.items()) {
    if (item >= document.nodes[place].end) return false;
    if (value.is_object() && document.nodes[item].key != key) return false;
    if (!is_same(document, item, expected)) return false;
    item = document.nodes[item].end;
    ++count;
  }
  return item == document.nodes[place].end && count == value.size();
}

bool is_same(const Document& document, std::size_t place, const ordered_json& value) {
  const auto& node = document.nodes[place];
  switch (node.type) {
    case Type::table:
      return value.is_object() && are_items_same(document, place, value);
    case Type::array:
      return value.is_array() && are_items_same(document, place, value);
    case Type::text:
      return value.is_string() && value.get_ref<const std::string&>() == node.text;
    case Type::number:
      // -0 is an integer to nlohmann, without a sign.
      return value.is_number() && (node.number == 0 ? value.get<double>() == 0
                                                    : std::bit_cast<std::uint64_t>(value.get<double>()) ==
                                                          std::bit_cast<std::uint64_t>(node.number));
    case Type::boolean:
      return value.is_boolean() && value.get<bool>() == node.boolean;
    default:
      return value.is_null();
  }
}

/// Limits of our own, which may be met before the text is seen to be no JSON.
bool is_own_limit(const std::string& code) {
  for (const char* limit : {"empty_line", "too_deep", "too_many_values", "duplicate_key", "not_finite"}) {
    if (code == limit) return true;
  }
  return false;
}

std::string wrong_answer(const std::string& text) {
  if (text.find_first_of("\r\n") != std::string::npos) return "the answer is no single line";
  const auto answer = ordered_json::parse(text, nullptr, false);
  if (!answer.is_object() || !answer.contains("id")) return "the answer is no object with an id";
  const std::string code = answer.contains("error") ? answer["error"].value("code", "") : "none";
  if (code.empty() || code == "internal_error") return "an error without a name";
  return "";
}

std::string wrong_reading(std::string_view line) {
  if (line.find('\0') != std::string_view::npos) return "";  // where nlohmann's text ends
  const ParsedLine parsed = parse_line(line);
  const std::string code = parsed.error ? parsed.error->code : "";
  const auto expected = ordered_json::parse(line, nullptr, false);
  if (expected.is_discarded()) return code == "malformed_json" || is_own_limit(code) ? "" : "taken for JSON";
  if (code == "malformed_json") return "not taken for JSON";
  return is_own_limit(code) || is_same(parsed.document, 0, expected) ? "" : "read as something else";
}

}  // namespace

std::string broken_promise(std::string_view line) {
  const std::string text = eval_line(line);
  std::string wrong = wrong_answer(text);
  if (wrong.empty()) wrong = wrong_reading(line);
  return wrong.empty() ? wrong
                       : fmt::format("{}: {} -> {}", wrong, line.substr(0, 2000), text.substr(0, 500));
}

}  // namespace halfway::reports::test
