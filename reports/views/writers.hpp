// The report's files, each a view of the same Results.
#pragma once

#include "reports/views/files.hpp"
#include "reports/views/results.hpp"

#include <filesystem>
#include <string>

namespace halfway::reports {

/// results.json, documented in reports/SCHEMA.md. NaN and infinity become null.
std::string results_json(const Results& results);

/// summary.md: verdict counts, the accuracy table, what failed or was left out and why.
std::string summary_markdown(const Results& results);

/// junit.xml: one test case per finding, grouped by subject, and one per benchmark; failures carry a
/// message, what was left out is skipped with its reason.
std::string junit_xml(const Results& results);

/// index.html: the page that the build bundled, with the results inlined. Throws FileError when the
/// page was not built or does not hold the placeholder.
std::string page_html(const Results& results);

/// The bundled page: $HALFWAY_PAGE, or the one of the build.
std::filesystem::path page_file();

/// Writes results.json, summary.md, junit.xml and index.html into `folder`. Throws FileError.
void write_report(const Results& results, const std::filesystem::path& folder);

}  // namespace halfway::reports
