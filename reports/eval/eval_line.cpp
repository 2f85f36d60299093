#include "reports/eval/eval_line.hpp"

#include "reference/scene/text/fields.hpp"
#include "reports/eval/eval_parse.hpp"
#include "reports/eval/eval_request.hpp"
#include "reports/eval/eval_written.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace halfway::reports {
namespace {

/// What `halfway check` asks first.
bool is_hello(ParsedLine& line) { return reference::Field(line.document).find("hello").has_value(); }

std::string hello(std::string_view id) {
  const nlohmann::ordered_json says = {{"name", "halfway eval"},
                                       {"kinds", {"angular", "linear", "linear_angular"}},
                                       {"law", "full"},
                                       {"digits", 15},
                                       {"answers", {"strain", "loads", "tangent", "energy"}}};
  return fmt::format(R"({{"id":{},{})", id, says.dump().substr(1));
}

}  // namespace

std::string eval_line(std::string_view text) {
  ParsedLine line;
  try {
    line = parse_line(text);
    if (line.error) throw *line.error;
    if (is_hello(line)) return hello(line.id);
    return written_answer(line.id, read_request(line.document), line.document);
  } catch (const reference::Refusal& e) {
    return written_refusal(line.id, e.code, e.what(), e.key);
  } catch (const std::exception& e) {
    return written_refusal(line.id, "internal_error", e.what(), "");
  }
}

std::string eval_refusal(std::string_view code, std::string_view message) {
  return written_refusal("null", code, message, "");
}

}  // namespace halfway::reports
