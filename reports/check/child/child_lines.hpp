// Bytes as they come from a pipe, split into lines of bounded length.
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>

namespace halfway::check {

inline constexpr std::size_t kLongestLine = 1'000'000;  ///< bytes; an answer has some hundred

struct Line {
  std::string text;                  ///< without its end; of one that is too long, the beginning
  bool is_too_long = false;          ///< longer than kLongestLine
  std::optional<std::size_t> nul{};  ///< where its first NUL byte is, from 1
};

class Lines {
 public:
  void add(std::string_view bytes);
  /// The next whole line; blank ones are passed over.
  std::optional<Line> next();
  /// What came after the last line end, if it is more than blanks.
  std::optional<Line> rest();

 private:
  void grow(std::string_view bytes);
  void close();

  Line open_;
  std::size_t length_ = 0;  ///< of the open line, however much of it is kept
  std::deque<Line> whole_;
};

/// Text of another program in a message: one line of valid UTF-8 that no terminal obeys, cut to `most` bytes.
std::string readable(std::string_view text, std::size_t most = 200);

}  // namespace halfway::check
