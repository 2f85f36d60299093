// What comes in pieces, in lines of bounded length.
#pragma once

#include <cstddef>
#include <functional>
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

  /// Waits for more bytes. @return  how many were written to the room it is given; 0: there are no more
  using Read = std::function<std::size_t(char* room, std::size_t size)>;

  InputLines(std::size_t longest, Read read);

  /// The next whole line of what was read; at the end of input also one without its end.
  std::optional<Line> next();
  /// @return  may there be a line now? There may be one more at the end of input.
  bool read_more();
  /// Bytes that were read and are of no line yet that was given out.
  std::size_t unread() const { return end_ - begin_; }

 private:
  Line line_to(std::size_t end);
  void make_room();

  std::size_t longest_;
  Read read_;
  std::vector<char> bytes_;
  std::size_t begin_ = 0, looked_at_ = 0, end_ = 0;  ///< of the line to come
  bool is_too_long_ = false;                         ///< its beginning was dropped
  bool is_over_ = false;
};

}  // namespace halfway::reports
