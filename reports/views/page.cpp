#include "reports/views/in_script.hpp"
#include "reports/views/writers.hpp"

#include <cstdlib>

#ifndef HALFWAY_PAGE_FILE
#define HALFWAY_PAGE_FILE ""
#endif

namespace halfway::reports {
namespace {

constexpr std::string_view kPlaceholder = "@HALFWAY_RESULTS@";

}  // namespace

std::filesystem::path page_file() {
  const char* file = std::getenv("HALFWAY_PAGE");
  return file && *file ? file : HALFWAY_PAGE_FILE;
}

std::string page_html(const Results& results) {
  const std::filesystem::path file = page_file();
  if (file.empty() || !std::filesystem::exists(file))
    throw FileError((file.empty() ? "page.html" : file.string()) +
                    ": the report page was not built; build the target report_page (it needs npm), or set "
                    "HALFWAY_PAGE to a built page");
  std::string page = read_file(file);
  const auto at = page.find(kPlaceholder);
  if (at == std::string::npos || page.find(kPlaceholder, at + 1) != std::string::npos)
    throw FileError(file.string() + ": not a report page: it must hold " + std::string(kPlaceholder) +
                    " once");
  const std::string json =
      nlohmann::json(results).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return page.replace(at, kPlaceholder.size(), in_script(json));
}

}  // namespace halfway::reports
