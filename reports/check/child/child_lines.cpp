#include "reports/check/child/child_lines.hpp"

#include "reports/cli/streams.hpp"

#include <nlohmann/json.hpp>

#include <utility>

namespace halfway::check {
namespace {

constexpr std::size_t kKeptOfTooLong = 4096;  // its id stands there

bool is_blank(const Line& line) {
  return !line.is_too_long && line.text.find_first_not_of(" \t\r") == std::string::npos;
}

}  // namespace

void Lines::add(std::string_view bytes) {
  for (std::size_t end; (end = bytes.find('\n')) != std::string_view::npos; bytes.remove_prefix(end + 1)) {
    grow(bytes.substr(0, end));
    close();
  }
  grow(bytes);
}

std::optional<Line> Lines::next() {
  if (whole_.empty()) return std::nullopt;
  Line line = std::move(whole_.front());
  whole_.pop_front();
  return line;
}

std::optional<Line> Lines::rest() {
  close();
  if (whole_.empty()) return std::nullopt;
  Line line = std::move(whole_.back());
  whole_.pop_back();
  return line;
}

void Lines::grow(std::string_view bytes) {
  const std::size_t nul = bytes.find('\0');
  if (nul != std::string_view::npos && !open_.nul) open_.nul = length_ + nul + 1;
  length_ += bytes.size();
  if (!open_.is_too_long) open_.text += bytes;
  if (length_ > kLongestLine) {
    open_.is_too_long = true;
    if (open_.text.size() > kKeptOfTooLong) open_.text.resize(kKeptOfTooLong);
  }
}

void Lines::close() {
  if (!open_.text.empty() && open_.text.back() == '\r') open_.text.pop_back();
  if (!is_blank(open_)) whole_.push_back(std::move(open_));
  open_ = {};
  length_ = 0;
}

std::string readable(std::string_view text, std::size_t most) {
  using nlohmann::json;
  const std::string cut(text.substr(0, most));
  // Writing with U+FFFD for what is no UTF-8, and reading again.
  const std::string valid =
      json::parse(json(cut).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
  return reports::printable(valid) + (text.size() > most ? "..." : "");
}

}  // namespace halfway::check
