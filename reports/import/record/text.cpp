#include "reports/import/record/text.hpp"

#include "reference/scene/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace halfway::imports {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\f\v";

Source part_of(const Source& at, std::string_view word) { return {at.line, at.key, std::string(word)}; }

}  // namespace

void refuse(const Source& at, const std::string& what, std::string_view allowed) {
  const std::string key = reference::shortened(at.key);
  throw reference::Refusal(
      "wrong_value",
      fmt::format("{} = {}: {}; allowed: {}", key,
                  at.text.empty() ? "nothing" : reference::shortened(at.text), what, allowed),
      key, at.line);
}

double number_of(const Source& at) {
  std::string text(trimmed(at.text));
  std::ranges::replace_if(
      text, [](char c) { return c == 'd' || c == 'D'; }, 'e');
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  const char* end = text.data() + text.size();
  double value = 0;
  const auto [rest, error] = std::from_chars(begin, end, value);
  const bool is_number =
      rest == end && begin != end && (error == std::errc{} || error == std::errc::result_out_of_range);
  if (!is_number || text.starts_with("+-")) refuse(at, "is no number", "a finite number");
  // What underflows is no smaller than nothing.
  if (error != std::errc{} && text.find("e-") != std::string::npos) return 0;
  if (error != std::errc{} || !std::isfinite(value)) refuse(at, "is not finite", "a finite number");
  return value;
}

std::vector<double> numbers_of(const Source& at, int count) {
  std::vector<double> out;
  std::string_view rest = trimmed(at.text);
  while (!rest.empty() && int(out.size()) <= count) {
    const std::string_view word = rest.substr(0, rest.find_first_of(kBlanks));
    out.push_back(number_of(part_of(at, word)));
    rest = trimmed(rest.substr(word.size()));
  }
  if (int(out.size()) != count)
    refuse(at, fmt::format("has {} numbers", int(out.size()) > count ? "more" : std::to_string(out.size())),
           fmt::format("{} numbers", count));
  return out;
}

double stiffness_of(const Source& at) {
  const double k = number_of(at);
  if (k < 0) refuse(at, "is a negative stiffness", "numbers >= 0");
  return k;
}

void check_stiffness(const Source& at, const std::vector<double>& values) {
  for (double k : values) {
    if (k < 0) refuse(at, fmt::format("has the negative stiffness {}", k), "numbers >= 0");
  }
}

std::string upper(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(),
                         [](unsigned char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : char(c); });
  return out;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    out.push_back(line);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
  }
  return out;
}

std::string named(const Source& at) {
  return fmt::format("{} = {} (line {})", reference::shortened(at.key),
                     reference::shortened(std::string(trimmed(at.text))), at.line);
}

void lose(ImportedJoint& joint, const Source& at, const std::vector<double>& values, std::string_view why) {
  if (std::ranges::any_of(values, [](double v) { return v != 0; }))
    joint.lost.push_back(fmt::format("{}: {}", named(at), why));
}

}  // namespace halfway::imports
