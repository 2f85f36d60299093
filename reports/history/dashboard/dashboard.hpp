// The history as the dashboard reads it: one page, its data in blocks that are inflated when they are shown.
#pragma once

#include "reports/history/record/history.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace halfway::history {

/// What got worse or better, and since which run.
struct Change {
  int figure = 0, series = 0, run = 0;
  double before = kNone, after = kNone;
  bool is_regression = false;
  double ratio = kNone;   ///< of times and counts
  double digits = kNone;  ///< of accuracy: gained
  double chance = kNone;  ///< of times: that there is no step
  std::string text;
};
std::vector<Change> find_changes(const History& history);

/// Its index, JSON. `generated`: now, UTC.
std::string index_json(const History& history, const std::vector<Change>& changes, const std::string& command,
                       const std::string& generated);
/// One figure: times a row a run, others where they changed.
std::string figure_json(const History& history, int figure);

/// Base64 of the deflated text, with zlib's header and checksum.
std::string packed(const std::string& text);

/// The template's one placeholder filled. Throws reports::BadInput that names the file.
std::string fill(const std::filesystem::path& file, const std::string& blocks);
/// $HALFWAY_DASHBOARD, or the one of the build.
std::filesystem::path template_file();

/// The whole page. Throws reports::BadInput.
std::string dashboard_html(const History& history, const std::string& command);

}  // namespace halfway::history
