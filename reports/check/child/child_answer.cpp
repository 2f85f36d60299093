#include "reports/check/child/child_answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace halfway::check {
namespace {

using nlohmann::json;

constexpr int kDeepest = 64;  // levels; an answer has two

/// The beginning of the text that is one JSON value, a string or a number.
std::string_view first_scalar(std::string_view text) {
  if (text.empty()) return text;
  if (text[0] != '"') return text.substr(0, text.find_first_not_of("+-.0123456789eE"));
  for (std::size_t i = 1; i < text.size(); ++i) {
    if (text[i] == '"') return text.substr(0, i + 1);
    if (text[i] == '\\') ++i;
  }
  return {};
}

/// The id of a line that is no JSON, or not whole.
std::optional<std::string> id_in_broken(std::string_view text) {
  std::size_t at = text.find("\"id\"");
  if (at == std::string_view::npos) return std::nullopt;
  at = text.find_first_not_of(" \t", at + 4);
  if (at == std::string_view::npos || text[at] != ':') return std::nullopt;
  at = text.find_first_not_of(" \t", at + 1);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view scalar = first_scalar(text.substr(at));
  // A number that the line breaks off in may go on.
  if (scalar.size() == text.size() - at && text[at] != '"') return std::nullopt;
  const json id = json::parse(scalar, nullptr, false);
  if (id.is_discarded()) return std::nullopt;
  return id_key(id);
}

/// A word outside strings that others write for numbers that are none.
std::optional<std::string> no_number(std::string_view text) {
  constexpr std::array<std::string_view, 3> kNames = {"nan", "inf", "infinity"};
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (in_string && text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      in_string = !in_string;
    } else if (!in_string && std::isalpha(static_cast<unsigned char>(text[i]))) {
      std::size_t end = i;
      while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
      std::string lower(text.substr(i, end - i));
      std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
      const bool has_sign = i > 0 && (text[i - 1] == '-' || text[i - 1] == '+');
      if (std::ranges::find(kNames, lower) != kNames.end())
        return fmt::format("{} at byte {}", text.substr(i - has_sign, end - i + has_sign), i + 1 - has_sign);
      i = end - 1;
    }
  }
  return std::nullopt;
}

/// Writing a value that is nested deep would need as deep a stack.
bool is_too_deep(std::string_view text) {
  int depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (in_string && text[i] == '\\') {
      ++i;
    } else if (text[i] == '"') {
      in_string = !in_string;
    } else if (!in_string && (text[i] == '[' || text[i] == '{')) {
      if (++depth > kDeepest) return true;
    } else if (!in_string && (text[i] == ']' || text[i] == '}')) {
      --depth;
    }
  }
  return false;
}

/// What nlohmann::json says, without its own name and place.
std::string reason(const json::exception& e, std::string_view text) {
  constexpr int kNumberOverflow = 406;
  const std::string_view what = e.what();
  if (e.id == kNumberOverflow) {
    const std::size_t quote = what.find('\'');
    const std::string_view number =
        quote == std::string_view::npos ? "" : what.substr(quote + 1, what.rfind('\'') - quote - 1);
    return fmt::format("the number {} is too large for double precision", readable(number, 40));
  }
  if (const auto word = no_number(text)) return *word + " is no number of JSON";
  const auto* const parse = dynamic_cast<const json::parse_error*>(&e);
  const std::size_t colon = what.find(": ");
  return fmt::format("byte {}: {}", parse != nullptr ? parse->byte : 0,
                     readable(what.substr(colon == std::string_view::npos ? 0 : colon + 2), 160));
}

/// What a program says in "skipped" or "error": text, or an object with a code and a message.
std::string told(const json& value) {
  const auto text = [](const json& part) {
    return readable(part.is_string() ? part.get<std::string>()
                                     : part.dump(-1, ' ', false, json::error_handler_t::replace));
  };
  if (!value.is_object() || !value.contains("message")) return text(value);
  return (value.contains("code") ? text(value["code"]) + ": " : "") + text(value["message"]);
}

Outcome outcome_of(json line) {
  Outcome outcome{.sort = Outcome::Sort::answered};
  if (line.contains("error")) {
    outcome.sort = Outcome::Sort::refused;
    outcome.words = told(line["error"]);
  } else if (line.contains("skipped")) {
    outcome.sort = Outcome::Sort::skipped;
    outcome.words = told(line["skipped"]);
  }
  outcome.line = std::move(line);
  return outcome;
}

Reading broken(const Line& line, Lost lost, std::string words) {
  return {true, id_in_broken(line.text), {.lost = lost, .words = std::move(words)}};
}

}  // namespace

const char* to_string(Outcome::Sort sort) {
  constexpr std::array kNames = {"answered", "skipped", "refused", "missing"};
  return kNames.at(std::size_t(sort));
}

const char* to_string(Lost lost) {
  constexpr std::array kNames = {"nothing",   "timed out", "crashed",  "wrong id", "not JSON",
                                 "truncated", "closed",    "too long", "NUL byte", "not asked"};
  return kNames.at(std::size_t(lost));
}

std::string id_key(const json& id) {
  if (!id.is_string() && !id.is_number()) return id.type_name();
  constexpr double kExact = 9007199254740992;  // 2^53
  if (id.is_number_float()) {
    const double value = id.get<double>();
    if (std::trunc(value) == value && std::abs(value) <= kExact)
      return json(static_cast<std::int64_t>(value)).dump();
  }
  return id.dump(-1, ' ', false, json::error_handler_t::replace);
}

Reading read_answer(const Line& line) {
  const std::size_t begin = line.text.find_first_not_of(" \t");
  if (begin == std::string::npos || line.text[begin] != '{') return {};
  if (line.is_too_long)
    return broken(line, Lost::too_long, fmt::format("a line of more than {} bytes", kLongestLine));
  if (line.nul)
    return broken(line, Lost::nul_byte, fmt::format("a NUL byte in the line, at byte {}", *line.nul));
  if (is_too_deep(line.text))
    return broken(line, Lost::not_json,
                  fmt::format("not JSON to be read: nested deeper than {} levels", kDeepest));
  try {
    json value = json::parse(line.text);
    Reading reading{true, std::nullopt, {}};
    if (value.contains("id")) reading.id = id_key(value["id"]);
    reading.is_answer = reading.id || value.contains("error") || value.contains("skipped") ||
                        value.contains("loads");  // else a log in JSON
    if (reading.is_answer) reading.outcome = outcome_of(std::move(value));
    return reading;
  } catch (const json::exception& e) {
    return broken(line, Lost::not_json, "not JSON: " + reason(e, line.text));
  }
}

}  // namespace halfway::check
