#include "reports/check/child/words.hpp"

#include "reports/cli/errors.hpp"

#include <fmt/format.h>

#include <optional>
#include <string_view>

namespace halfway::check {
namespace {

constexpr std::string_view kBlanks = " \t\n";
constexpr std::string_view kEscapedInQuotes = "$`\"\\";  // elsewhere in "..." a backslash stands for itself

/// Reads words off the front of a text.
class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::optional<std::string> next() {
    at_ = text_.find_first_not_of(kBlanks, at_);
    if (at_ == std::string_view::npos) return std::nullopt;
    std::string word;
    while (at_ < text_.size() && kBlanks.find(text_[at_]) == std::string_view::npos) take(word);
    return word;
  }

 private:
  void take(std::string& word) {
    const char c = text_[at_++];
    if (c == '\'') return single_quoted(word);
    if (c == '"') return double_quoted(word);
    if (c != '\\') {
      word += c;
    } else if (at_ == text_.size()) {
      throw reports::BadInput(fmt::format("the command ends with a lone backslash: {}", text_));
    } else {
      escaped(word);
    }
  }

  void single_quoted(std::string& word) {
    const std::size_t end = text_.find('\'', at_);
    if (end == std::string_view::npos) refuse_open(at_, '\'');
    word += text_.substr(at_, end - at_);
    at_ = end + 1;
  }

  void double_quoted(std::string& word) {
    const std::size_t begin = at_;
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"') return;
      const bool escapes =
          c == '\\' && at_ < text_.size() &&
          (text_[at_] == '\n' || kEscapedInQuotes.find(text_[at_]) != std::string_view::npos);
      if (escapes)
        escaped(word);
      else
        word += c;
    }
    refuse_open(begin, '"');
  }

  /// The character after a backslash; a line end goes with it.
  void escaped(std::string& word) {
    const char c = text_[at_++];
    if (c != '\n') word += c;
  }

  /// @param position  of the quote, from 1
  [[noreturn]] void refuse_open(std::size_t position, char quote) const {
    throw reports::BadInput(fmt::format("the quote {} at character {} of the command is never closed: {}",
                                        quote, position, text_));
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<std::string> words_of(const std::string& command) {
  Reader reader(command);
  std::vector<std::string> words;
  while (auto word = reader.next()) words.push_back(std::move(*word));
  if (words.empty() || words[0].empty())
    throw reports::BadInput(
        "the command is empty; it names a program and its arguments, \"python3 adapter.py\"");
  return words;
}

}  // namespace halfway::check
