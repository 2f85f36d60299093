#include "reports/eval/json_scanner.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <cstring>

namespace halfway::reports {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_high_surrogate(unsigned unit) { return unit >= 0xD800 && unit < 0xDC00; }
bool is_low_surrogate(unsigned unit) { return unit >= 0xDC00 && unit < 0xE000; }

/// ASCII that stands for itself in a text.
bool is_plain(unsigned char c) { return c >= 0x20 && c < 0x80 && c != '"' && c != '\\'; }

/// Bytes of the character at the beginning of `s`, which is not ASCII; 0: no UTF-8 (RFC 3629).
std::size_t utf8_length(std::string_view s) {
  constexpr unsigned kLeast[] = {0, 0, 0x80, 0x800, 0x10000};  // of so many bytes: none is longer than needed
  const unsigned lead = static_cast<unsigned char>(s[0]);
  const std::size_t length = lead < 0xC0 ? 0 : lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : lead < 0xF8 ? 4 : 0;
  if (length == 0 || s.size() < length) return 0;
  unsigned point = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned next = static_cast<unsigned char>(s[i]);
    if ((next & 0xC0) != 0x80) return 0;
    point = point << 6 | (next & 0x3F);
  }
  const bool is_surrogate = is_high_surrogate(point) || is_low_surrogate(point);
  return point < kLeast[length] || point > 0x10FFFF || is_surrogate ? 0 : length;
}

void append_utf8(std::string& out, unsigned point) {
  const auto next = [&](int shift) { out += char(0x80 | (point >> shift & 0x3F)); };
  if (point < 0x80) {
    out += char(point);
  } else if (point < 0x800) {
    out += char(0xC0 | point >> 6), next(0);
  } else if (point < 0x10000) {
    out += char(0xE0 | point >> 12), next(6), next(0);
  } else {
    out += char(0xF0 | point >> 18), next(12), next(6), next(0);
  }
}

}  // namespace

JsonScanner::JsonScanner(std::string_view text, reference::Document& keeper)
    : begin_(text.data()), at_(begin_), end_(begin_ + text.size()), keeper_(&keeper) {
  if (text.starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
}

void JsonScanner::refuse(const char* expected) const {
  throw reference::Refusal("malformed_json",
                           fmt::format("not JSON at byte {}: {}", at_ - begin_ + 1, expected), "");
}

std::string_view JsonScanner::number(double& value) {
  const char* const first = at_;
  const char* const integer = first + (*first == '-');
  if (integer == end_ || !is_digit(*integer)) refuse("expected a digit");
  const auto [last, error] = std::from_chars(first, end_, value);
  // What from_chars takes and JSON does not: 01, 1. and 1.e5.
  if (*integer == '0' && last - integer > 1 && is_digit(integer[1])) refuse("a number with a leading zero");
  const void* const point = std::memchr(integer, '.', std::size_t(last - integer));
  if (point != nullptr) {
    at_ = static_cast<const char*>(point) + 1;
    if (at_ == last || !is_digit(*at_)) refuse("expected a digit");
  }
  at_ = last;
  // Too small or too large for a double: strtod tells which.
  if (error != std::errc{}) value = std::strtod(std::string(first, last).c_str(), nullptr);
  return {first, std::size_t(last - first)};
}

std::string_view JsonScanner::text() {
  demand('"', "expected a text in quotes");
  const char* const first = at_;
  while (at_ != end_ && is_plain(static_cast<unsigned char>(*at_))) ++at_;
  if (at_ != end_ && *at_ == '"') return {first, std::size_t(at_++ - first)};
  at_ = first;
  return text_with_escapes();
}

std::string_view JsonScanner::text_with_escapes() {
  std::string out;
  while (at_ != end_ && *at_ != '"') {
    if (*at_ == '\\') {
      ++at_;
      add_escape(out);
      continue;
    }
    const std::size_t length =
        is_plain(static_cast<unsigned char>(*at_)) ? 1 : utf8_length({at_, std::size_t(end_ - at_)});
    if (length == 0) refuse("a byte inside a text that is a control character or no UTF-8");
    out.append(at_, length);
    at_ += length;
  }
  if (at_ == end_) refuse("expected the end of a text");
  ++at_;
  return keeper_->keep(std::move(out));
}

void JsonScanner::add_escape(std::string& out) {
  constexpr const char* kShort = "\"\\/bfnrt";
  constexpr const char* kMeaning = "\"\\/\b\f\n\r\t";
  const char c = at_ == end_ ? '\0' : *at_;
  if (c == 'u') {
    ++at_;
    unsigned point = hex4();
    if (is_high_surrogate(point)) {
      if (end_ - at_ < 2 || at_[0] != '\\' || at_[1] != 'u') refuse("expected the other half of a surrogate");
      at_ += 2;
      const unsigned low = hex4();
      if (!is_low_surrogate(low)) refuse("expected the other half of a surrogate");
      point = 0x10000 + ((point - 0xD800) << 10) + (low - 0xDC00);
    } else if (is_low_surrogate(point)) {
      refuse("half of a surrogate alone");
    }
    return append_utf8(out, point);
  }
  const char* const found = c == '\0' ? nullptr : std::strchr(kShort, c);
  if (found == nullptr) refuse("an unknown escape");
  out += kMeaning[found - kShort];
  ++at_;
}

unsigned JsonScanner::hex4() {
  unsigned value = 0;
  for (int i = 0; i < 4; ++i, ++at_) {
    const char c = at_ == end_ ? '\0' : *at_;
    const char lower = char(c | 0x20);
    if (is_digit(c))
      value = value * 16 + unsigned(c - '0');
    else if (lower >= 'a' && lower <= 'f')
      value = value * 16 + unsigned(lower - 'a' + 10);
    else
      refuse("expected four hexadecimal digits");
  }
  return value;
}

void JsonScanner::demand_word(const char* word) {
  for (; *word != '\0'; ++word, ++at_) {
    if (at_ == end_ || *at_ != *word) refuse("expected a value");
  }
}

void JsonScanner::demand_end() {
  peek();
  if (at_ != end_) refuse("expected the end of the line");
}

}  // namespace halfway::reports
