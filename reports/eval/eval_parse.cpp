#include "reports/eval/eval_parse.hpp"

#include "reports/eval/json_scanner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::reports {
namespace {

using reference::DocumentNode;
using reference::Refusal;
using Type = DocumentNode::Type;

/// Without the spaces between its values: an answer is one line for every reader.
std::string without_spaces(std::string_view json) {
  std::string out;
  bool in_text = false;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const char c = json[i];
    if (c == '"') in_text = !in_text;
    if (in_text && c == '\\') out += json[i++];
    if (in_text || (c != ' ' && c != '\t' && c != '\r' && c != '\n')) out += json[i];
  }
  return out;
}

/// Builds the tree, bounded in depth and size.
class Builder {
 public:
  Builder(std::string_view text, ParsedLine& line)
      : scanner_(text, line.document), line_(&line), document_(&line.document) {}

  void build() {
    add_value({});
    scanner_.demand_end();
  }

 private:
  DocumentNode& add(Type type, std::string_view key) {
    if (document_->nodes.size() == kMostValues)
      throw Refusal("too_many_values", fmt::format("a line of more than {} values", kMostValues), "");
    return document_->add(type, key);
  }

  void add_value(std::string_view key) {
    switch (const char c = scanner_.peek()) {
      case '{':
        return add_table(key);
      case '[':
        return add_array(key);
      case '"':
        add(Type::text, key).text = scanner_.text();
        return;
      case 't':
      case 'f':
        scanner_.demand_word(c == 't' ? "true" : "false");
        add(Type::boolean, key).boolean = c == 't';
        return;
      case 'n':
        scanner_.demand_word("null");
        add(Type::nothing, key);
        return;
      default:
        if (c != '-' && (c < '0' || c > '9')) scanner_.refuse("expected a value");
        return add_number(key);
    }
  }

  void add_number(std::string_view key) {
    DocumentNode& node = add(Type::number, key);
    node.text = scanner_.number(node.number);
    if (!std::isfinite(node.number)) {
      throw Refusal("not_finite", "a number is too large for double precision",
                    path_of(*document_, document_->nodes.size() - 1));
    }
  }

  std::size_t open(Type type, std::string_view key) {
    if (depth_ == reference::kDeepestNesting) {
      throw Refusal("too_deep", fmt::format("nested deeper than {} levels", reference::kDeepestNesting), "");
    }
    ++depth_;
    add(type, key);
    return document_->nodes.size() - 1;
  }

  void close(std::size_t place) {
    document_->close(place);
    --depth_;
  }

  void add_array(std::string_view key) {
    scanner_.take('[');
    const std::size_t place = open(Type::array, key);
    if (!scanner_.take(']')) {
      do add_item();
      while (scanner_.take(','));
      scanner_.demand(']', "expected ',' or ']'");
    }
    close(place);
  }

  /// Most are numbers.
  void add_item() {
    const char c = scanner_.peek();
    c == '-' || (c >= '0' && c <= '9') ? add_number({}) : add_value({});
  }

  void add_table(std::string_view key) {
    scanner_.take('{');
    const std::size_t place = open(Type::table, key);
    if (!scanner_.take('}')) {
      do add_member();
      while (scanner_.take(','));
      scanner_.demand('}', "expected ',' or '}'");
      refuse_twins(place);
    }
    close(place);
  }

  void add_member() {
    if (scanner_.peek() != '"') scanner_.refuse("expected a key in quotes");
    const std::string_view key = scanner_.text();
    scanner_.demand(':', "expected ':'");
    scanner_.peek();
    const char* const begin = scanner_.place();
    add_value(key);
    if (depth_ != 1 || key != "id" || has_id_) return;
    has_id_ = true;
    line_->id = without_spaces({begin, std::size_t(scanner_.place() - begin)});
  }

  void refuse_twins(std::size_t table) {
    const auto& nodes = document_->nodes;
    members_.clear();
    for (std::size_t item = table + 1; item < nodes.size(); item = nodes[item].end)
      members_.emplace_back(nodes[item].key, item);
    std::ranges::sort(members_);
    const auto twin = std::ranges::adjacent_find(members_, {}, &Member::first);
    if (twin == members_.end()) return;
    const std::string path = path_of(*document_, std::next(twin)->second);
    throw Refusal(
        "duplicate_key",
        fmt::format("'{}' stands twice in one object", reference::shortened(std::string(twin->first))), path);
  }

  using Member = std::pair<std::string_view, std::size_t>;

  JsonScanner scanner_;
  ParsedLine* line_;
  reference::Document* document_;
  int depth_ = 0;
  bool has_id_ = false;
  std::vector<Member> members_;  ///< of the object that is closed: one memory for all
};

void build(std::string_view text, ParsedLine& line) {
  if (text.find_first_not_of(" \t\r") == std::string_view::npos)
    throw Refusal("empty_line", "the line is empty; a request is one JSON object per line", "");
  constexpr std::size_t kUsualBytes = 8;  // of a value with its commas and keys
  line.document.nodes.reserve(std::min(kMostValues, 16 + text.size() / kUsualBytes));
  Builder(text, line).build();
  const Type type = line.document.nodes.front().type;
  if (type != Type::table) {
    throw Refusal("not_an_object",
                  fmt::format("a request is a JSON object, found: {}", reference::type_name(type)), "");
  }
}

}  // namespace

ParsedLine parse_line(std::string_view text) {
  ParsedLine line{{.dialect = reference::kRequest}};
  try {
    build(text, line);
  } catch (Refusal& refusal) {
    line.error = std::move(refusal);
  }
  return line;
}

}  // namespace halfway::reports
