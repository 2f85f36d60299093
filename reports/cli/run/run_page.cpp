#include "reports/cli/run/run_page.hpp"

#include "reports/views/in_script.hpp"

namespace halfway::reports {

std::string run_page(const Json& data) {
  std::string out;
  for (const std::string_view part : page_before_data()) out += part;
  out += in_script(data.dump(-1, ' ', false, Json::error_handler_t::replace));
  for (const std::string_view part : page_after_data()) out += part;
  return out;
}

}  // namespace halfway::reports
