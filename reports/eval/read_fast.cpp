#include "reports/eval/read_fast.hpp"

#include <simdjson.h>

#include <cmath>
#include <cstdlib>
#include <string>

namespace halfway::reports {
namespace {

namespace ondemand = simdjson::ondemand;
using ondemand::json_type;

void add_value(ondemand::value value, LineTree& tree);

void add_array(ondemand::array array, LineTree& tree) {
  tree.open_array();
  for (ondemand::value item : array) add_value(item, tree);
  tree.close_array();
}

void add_table(ondemand::object object, LineTree& tree) {
  tree.open_table();
  for (ondemand::field field : object) {
    tree.key(field.unescaped_key());
    add_value(field.value(), tree);
  }
  tree.close_table();
}

/// Its token goes on to the next one.
std::string_view without_spaces_behind(std::string_view token) {
  return token.substr(0, token.find_last_not_of(" \t\r\n") + 1);
}

/// simdjson 3.0 reads some numbers of more than 19 digits wrongly: 0.99999999999999999999999 as 2e-6.
void add_number(ondemand::value value, LineTree& tree) {
  constexpr std::size_t kSurelyRight = 21;  // 19 digits behind "0."
  const std::string_view written = without_spaces_behind(value.raw_json_token());
  double number = value.get_double();
  if (written.size() > kSurelyRight) number = std::strtod(written.data(), nullptr);
  if (!std::isfinite(number)) throw simdjson::simdjson_error(simdjson::NUMBER_ERROR);
  tree.add_number(number, written);
}

void add_null(ondemand::value value, LineTree& tree) {
  if (!value.is_null()) throw simdjson::simdjson_error(simdjson::N_ATOM_ERROR);
  tree.add_nothing();
}

void add_value(ondemand::value value, LineTree& tree) {
  switch (json_type(value.type())) {
    case json_type::object:
      return add_table(value.get_object(), tree);
    case json_type::array:
      return add_array(value.get_array(), tree);
    case json_type::string:
      return tree.add_text(value.get_string());
    case json_type::boolean:
      return tree.add_boolean(value.get_bool());
    case json_type::null:
      return add_null(value, tree);
    case json_type::number:
      return add_number(value, tree);
  }
}

}  // namespace

bool read_fast(std::string_view line, reference::Document& document) {
  // One memory for all lines.
  static thread_local ondemand::parser parser;
  static thread_local std::string padded;
  padded.assign(line);
  padded.append(simdjson::SIMDJSON_PADDING, '\0');
  LineTree tree(document);
  try {
    ondemand::document json = parser.iterate(padded.data(), line.size(), padded.size());
    add_table(json.get_object(), tree);
    return json.current_location().error() == simdjson::OUT_OF_BOUNDS;  // nothing comes behind it
  } catch (const simdjson::simdjson_error&) {
    return false;
  } catch (const reference::Refusal&) {
    return false;
  }
}

}  // namespace halfway::reports
