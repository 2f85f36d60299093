// Standard input in lines of bounded length, as they come.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace halfway::reports {

class InputLines {
 public:
  struct Line {
    std::string_view text;  ///< without its end; good until more is read
    bool is_too_long = false;
  };

  explicit InputLines(std::size_t longest);

  /// The next whole line of what was read; at the end of input also one without its end.
  std::optional<Line> next();
  /// Waits for more. @return  was there any, or a line that the end of input made whole? Throws FailedRun.
  bool read_more();

 private:
  Line line_to(std::size_t end);
  void make_room();

  std::size_t longest_;
  std::vector<char> bytes_;
  std::size_t begin_ = 0, looked_at_ = 0, end_ = 0;  ///< of the line to come
  bool is_too_long_ = false;                         ///< its beginning was dropped
  bool is_over_ = false;
};

}  // namespace halfway::reports
