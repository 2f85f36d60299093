// Strict JSON (RFC 8259) from left to right: what a parser of a tree asks of the text.
#pragma once

#include "reference/scene/document.hpp"

#include <string>
#include <string_view>

namespace halfway::reports {

/// Every member throws Refusal [malformed_json], with the byte where the text is no JSON.
class JsonScanner {
 public:
  /// @param text    has to outlive the scanner, and what it returns
  /// @param keeper  keeps the texts that are not in there as they are: those with escapes
  JsonScanner(std::string_view text, reference::Document& keeper);

  /// The next character that is no space; 0 at the end.
  char peek() {
    for (; at_ != end_; ++at_) {
      if (*at_ > ' ' || (*at_ != ' ' && *at_ != '\t' && *at_ != '\r' && *at_ != '\n')) return *at_;
    }
    return '\0';
  }
  /// Goes past the next character if it is this one.
  bool take(char c) {
    if (peek() != c || at_ == end_) return false;
    ++at_;
    return true;
  }
  void demand(char c, const char* expected) {
    if (!take(c)) refuse(expected);
  }

  /// As it is written. @param value  the nearest double, infinite where it is too large
  std::string_view number(double& value);
  std::string_view text();             ///< without its quotes, escapes resolved; UTF-8
  void demand_word(const char* word);  ///< true, false, null
  void demand_end();

  const char* place() const { return at_; }
  /// @param expected  "expected a value"
  [[noreturn]] void refuse(const char* expected) const;

 private:
  std::string_view text_with_escapes();
  void add_escape(std::string& out);
  unsigned hex4();

  const char *begin_, *at_, *end_;
  reference::Document* keeper_;
};

}  // namespace halfway::reports
