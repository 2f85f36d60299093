#include "reports/views/writers.hpp"

namespace halfway::reports {

std::string results_json(const Results& results) {
  // Text from other programs (machine names, exception messages) may not be UTF-8: replaced, not fatal.
  return nlohmann::json(results).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void write_report(const Results& results, const std::filesystem::path& folder) {
  write_file(folder / "results.json", results_json(results));
  write_file(folder / "summary.md", summary_markdown(results));
  write_file(folder / "junit.xml", junit_xml(results));
  write_file(folder / "index.html", page_html(results));
}

}  // namespace halfway::reports
