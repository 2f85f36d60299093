// The history as text, JSON lines: what `import` takes, and what a repository keeps for people to review.
#pragma once

#include "reports/history/record/history.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace halfway::history {

/// All that a file keeps, a run a line; `run`: that one alone, with all of its figures. Back by read_lines.
std::string json_lines(const History& history, int run);
/// Throws reports::BadInput that names the line.
void read_lines(const std::string& text, const std::string& name,
                const std::function<void(const Record&)>& sink);

/// Is this such a text, by its first bytes?
bool is_lines(const std::filesystem::path& file);
/// All of it. Throws reports::BadInput that names the line; runs out of the order of their dates too.
History read_history(const std::filesystem::path& file);

}  // namespace halfway::history
