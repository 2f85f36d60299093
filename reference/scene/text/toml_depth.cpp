#include "reference/scene/text/toml_depth.hpp"

#include "reference/scene/text/document.hpp"

namespace halfway::reference {
namespace {

/// Where the string that begins at `at` ends, one past its last quote; at the line end, if it is of one
/// line and never closed.
std::size_t end_of_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = quote == '"' ? R"(""")" : "'''";
  const bool is_long = text.substr(at).starts_with(three);
  const std::string_view mark = is_long ? three : three.substr(0, 1);
  std::size_t i = at + mark.size();
  for (; i < text.size(); ++i) {
    if (quote == '"' && text[i] == '\\') {
      ++i;
    } else if (!is_long && text[i] == '\n') {
      return i;
    } else if (text.substr(i).starts_with(mark)) {
      i += mark.size();
      // Up to two quotes more belong to a long string: """a""""".
      for (int more = 0; is_long && more < 2 && i < text.size() && text[i] == quote; ++more) ++i;
      return i;
    }
  }
  return text.size();
}

}  // namespace

int line_of_deep_key(std::string_view text) {
  int line = 1, dots = 0;
  for (std::size_t i = 0; i < text.size();) {
    const char c = text[i];
    std::size_t next = i + 1;
    if (c == '"' || c == '\'') {
      next = end_of_string(text, i);
    } else if (c == '#') {
      next = text.find('\n', i);
      if (next == std::string_view::npos) return 0;
    } else if (c == '.') {
      if (++dots >= kDeepestNesting) return line;
    } else if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) {
      dots = 0;
    }
    for (std::size_t k = i; k < next && k < text.size(); ++k) line += text[k] == '\n';
    i = next;
  }
  return 0;
}

}  // namespace halfway::reference
