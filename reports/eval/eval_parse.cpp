#include "reports/eval/eval_parse.hpp"

#include "reports/eval/read_fast.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace halfway::reports {
namespace {

using nlohmann::json;
using reference::Document;
using reference::Refusal;
using Type = reference::DocumentNode::Type;

constexpr int kNumberOverflow = 406;  // of nlohmann::json

std::string cut(std::string_view text) {
  constexpr std::size_t kLongest = 160;
  return std::string(text.substr(0, kLongest)) + (text.size() > kLongest ? "..." : "");
}

/// From nlohmann's events to the tree, which throws where it has to refuse.
class Events : public json::json_sax_t {
 public:
  explicit Events(Document& document) : document_(&document), tree_(document) {}

  bool null() override { return tree_.add_nothing(), true; }
  bool boolean(bool value) override { return tree_.add_boolean(value), true; }
  bool number_integer(number_integer_t value) override {
    return number_float(double(value), fmt::format("{}", value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return number_float(double(value), fmt::format("{}", value));
  }
  bool number_float(number_float_t value, const string_t& written) override {
    return tree_.add_number(value, document_->keep(written)), true;
  }
  bool string(string_t& value) override { return tree_.add_text(document_->keep(std::move(value))), true; }
  bool binary(binary_t&) override { return false; }  // not in text
  bool start_object(std::size_t) override { return tree_.open_table(), true; }
  bool key(string_t& name) override { return tree_.key(document_->keep(std::move(name))), true; }
  bool end_object() override { return tree_.close_table(), true; }
  bool start_array(std::size_t) override { return tree_.open_array(), true; }
  bool end_array() override { return tree_.close_array(), true; }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception& e) override {
    if (e.id == kNumberOverflow) tree_.refuse_overflow();
    throw Refusal("malformed_json", fmt::format("not JSON at byte {}: {}", byte, cut(e.what())), "");
  }

 private:
  Document* document_;
  LineTree tree_;
};

/// By nlohmann, from left to right, until something is wrong: what, where, and what came before it, which
/// simdjson does not say.
void read_slowly(std::string_view text, Document& document) {
  Events events(document);
  json::sax_parse(text.begin(), text.end(), &events);
  const Type type = document.nodes.front().type;
  if (type != Type::table) {
    throw Refusal("not_an_object",
                  fmt::format("a request is a JSON object, found: {}", reference::type_name(type)), "");
  }
}

Document new_document(std::string_view text) {
  constexpr std::size_t kUsualBytes = 8;  // of a value with its commas and keys
  Document document{.dialect = reference::kRequest};
  document.nodes.reserve(std::min(kMostValues, 16 + text.size() / kUsualBytes));
  return document;
}

}  // namespace

ParsedLine parse_line(std::string_view text) {
  if (text.find_first_not_of(" \t\r") == std::string_view::npos) {
    return {.document = {},
            .error = Refusal("empty_line", "the line is empty; a request is one JSON object per line", "")};
  }
  ParsedLine line{new_document(text)};
  if (!read_fast(text, line.document)) {
    line.document = new_document(text);
    try {
      read_slowly(text, line.document);
    } catch (Refusal& refusal) {
      line.error = std::move(refusal);
    }
  }
  line.id = id_of(line.document);
  return line;
}

}  // namespace halfway::reports
