// A command line as words. No shell is ever run, and nothing is expanded.
#pragma once

#include <string>
#include <vector>

namespace halfway::check {

/// The words a POSIX shell would see by its quotes ('...', "...") and backslashes alone: $, *, | and ~ stand
/// for themselves. Throws reports::BadInput for a quote that stays open and for a command without a word.
std::vector<std::string> words_of(const std::string& command);

}  // namespace halfway::check
