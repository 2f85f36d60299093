#include "reports/cli/input_lines.hpp"

#include "reports/cli/commands.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace halfway::reports {

InputLines::InputLines(std::size_t longest) : longest_(longest), bytes_(std::size_t(64) << 10) {}

std::optional<InputLines::Line> InputLines::next() {
  const char* const from = bytes_.data() + looked_at_;
  const void* const found = std::memchr(from, '\n', end_ - looked_at_);
  looked_at_ = found ? std::size_t(static_cast<const char*>(found) - bytes_.data()) : end_;
  if (looked_at_ < end_) {
    const Line line = line_to(looked_at_);
    begin_ = ++looked_at_;
    return line;
  }
  if (!is_over_ || (begin_ == end_ && !is_too_long_)) return std::nullopt;
  const Line line = line_to(end_);
  begin_ = end_;
  return line;
}

InputLines::Line InputLines::line_to(std::size_t end) {
  const bool was_too_long = std::exchange(is_too_long_, false) || end - begin_ > longest_;
  return {{bytes_.data() + begin_, end - begin_}, was_too_long};
}

void InputLines::make_room() {
  if (end_ - begin_ > longest_) {
    is_too_long_ = true;
    begin_ = end_;
  }
  std::copy(bytes_.begin() + std::ptrdiff_t(begin_), bytes_.begin() + std::ptrdiff_t(end_), bytes_.begin());
  end_ -= begin_;
  looked_at_ = end_;
  begin_ = 0;
  if (end_ == bytes_.size()) bytes_.resize(2 * bytes_.size());
}

bool InputLines::read_more() {
  if (is_over_) return false;
  make_room();
  ssize_t count = 0;
  do count = ::read(STDIN_FILENO, bytes_.data() + end_, bytes_.size() - end_);
  while (count < 0 && errno == EINTR);
  if (count < 0) throw FailedRun("cannot read standard input");
  end_ += std::size_t(count);
  is_over_ = count == 0;
  return true;
}

}  // namespace halfway::reports
