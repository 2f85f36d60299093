#include "reports/eval/input_lines.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace halfway::reports {

InputLines::InputLines(std::size_t longest, Read read)
    : longest_(longest), read_(std::move(read)), bytes_(std::size_t(64) << 10) {}

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
    begin_ = looked_at_ = end_;
  }
  if (begin_ > 0)
    std::copy(bytes_.begin() + std::ptrdiff_t(begin_), bytes_.begin() + std::ptrdiff_t(end_), bytes_.begin());
  end_ -= begin_;
  looked_at_ -= begin_;
  begin_ = 0;
  if (end_ == bytes_.size()) bytes_.resize(2 * bytes_.size());
}

bool InputLines::read_more() {
  if (is_over_) return false;
  make_room();
  const std::size_t count = read_(bytes_.data() + end_, bytes_.size() - end_);
  end_ += count;
  is_over_ = count == 0;
  return true;
}

}  // namespace halfway::reports
