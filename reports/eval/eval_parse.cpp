#include "reports/eval/eval_parse.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace halfway::reports {
namespace {

using nlohmann::json;
using reference::DocumentNode;
using reference::Refusal;
using Type = DocumentNode::Type;

constexpr int kNumberOverflow = 406;  // of nlohmann::json

std::string quoted(const std::string& text) { return json(text).dump(); }

/// A value as JSON, numbers as they came: an id may be larger than any integer type.
std::string json_text(const DocumentNode& node) {
  switch (node.type) {
    case Type::text:
      return quoted(node.text);
    case Type::number:
      return node.text;
    case Type::boolean:
      return node.boolean ? "true" : "false";
    case Type::table:
    case Type::array:
      break;
    default:
      return "null";
  }
  const bool is_table = node.type == Type::table;
  std::string out;
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    if (i > 0) out += ',';
    if (is_table) out += quoted(node.keys[i]) + ':';
    out += json_text(node.items[i]);
  }
  return is_table ? '{' + out + '}' : '[' + out + ']';
}

/// The first key that an object has twice, if any.
std::optional<std::string> repeated(std::vector<std::string> keys) {
  std::ranges::sort(keys);
  const auto twin = std::ranges::adjacent_find(keys);
  if (twin == keys.end()) return std::nullopt;
  return *twin;
}

std::string cut(std::string_view text) {
  constexpr std::size_t kLongest = 160;
  return std::string(text.substr(0, kLongest)) + (text.size() > kLongest ? "..." : "");
}

/// Builds the tree from the parser's events. A handler of our own, because the library's gives neither a
/// depth limit nor the place where a number overflowed nor what was read before an error.
class Builder : public nlohmann::json_sax<json> {
 public:
  bool null() override { return add({.type = Type::nothing}); }
  bool boolean(bool value) override { return add({.type = Type::boolean, .boolean = value}); }
  bool number_integer(number_integer_t value) override { return add_number(value, fmt::format("{}", value)); }
  bool number_unsigned(number_unsigned_t value) override {
    return add_number(value, fmt::format("{}", value));
  }
  bool number_float(number_float_t value, const string_t& written) override {
    return add_number(value, written);
  }
  bool string(string_t& value) override { return add({.type = Type::text, .text = std::move(value)}); }
  bool binary(binary_t&) override { return false; }  // not in text
  bool key(string_t& name) override {
    open_.back()->keys.push_back(std::move(name));
    return true;
  }
  bool start_object(std::size_t) override { return open(Type::table); }
  bool start_array(std::size_t) override { return open(Type::array); }
  bool end_array() override { return close(); }
  bool end_object() override {
    if (const auto key = repeated(open_.back()->keys)) {
      open_.back()->keys.back() = *key;
      return fail("duplicate_key", fmt::format("'{}' stands twice in one object", cut(*key)), path());
    }
    return close();
  }

  bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception& e) override {
    if (e.id == kNumberOverflow)
      return fail("not_finite", "a number is too large for double precision", path());
    return fail("malformed_json", fmt::format("not JSON at byte {}: {}", position, cut(e.what())), "");
  }

  ParsedLine take() {
    ParsedLine line{{std::move(root_), reference::kRequest}, "null", std::move(error_)};
    const DocumentNode& root = line.document.root;
    const auto id = std::ranges::find(root.keys, "id");
    const auto i = std::size_t(id - root.keys.begin());
    const bool is_whole = i < root.items.size() && !(open_.size() > 1 && i + 1 == root.items.size());
    if (id != root.keys.end() && is_whole) line.id = json_text(root.items[i]);
    return line;
  }

 private:
  bool fail(const char* code, const std::string& message, const std::string& key) {
    error_.emplace(code, message, key);
    return false;
  }

  bool add_number(double value, std::string written) {
    return add({.type = Type::number, .number = value, .text = std::move(written)});
  }

  /// Into the innermost open container; a table has the key already.
  bool add(DocumentNode value) {
    if (++count_ > kMostValues)
      return fail("too_many_values", fmt::format("a line of more than {} values", kMostValues), "");
    if (open_.empty())
      root_ = std::move(value);
    else
      open_.back()->items.push_back(std::move(value));
    return true;
  }

  bool open(Type type) {
    if (open_.size() == std::size_t(reference::kDeepestNesting)) {
      return fail("too_deep", fmt::format("nested deeper than {} levels", reference::kDeepestNesting), "");
    }
    if (!add({.type = type})) return false;
    open_.push_back(open_.empty() ? &root_ : &open_.back()->items.back());
    return true;
  }

  bool close() {
    open_.pop_back();
    return true;
  }

  /// Of the value being read.
  std::string path() const {
    std::string text;
    for (const DocumentNode* level : open_) {
      if (level->type == Type::array) {
        const bool holds_next_level = level != open_.back();
        text += fmt::format("[{}]", level->items.size() - holds_next_level);
      } else if (!level->keys.empty()) {
        text += (text.empty() ? "" : ".") + cut(level->keys.back());
      }
    }
    return text;
  }

  DocumentNode root_;
  std::vector<DocumentNode*> open_;  ///< each the last item of the one before: none of them moves
  std::size_t count_ = 0;
  std::optional<Refusal> error_;
};

}  // namespace

ParsedLine parse_line(std::string_view line) {
  if (line.find_first_not_of(" \t\r") == std::string_view::npos) {
    return {
        {}, "null", Refusal("empty_line", "the line is empty; a request is one JSON object per line", "")};
  }
  Builder builder;
  json::sax_parse(line.begin(), line.end(), &builder);
  ParsedLine parsed = builder.take();
  const Type type = parsed.document.root.type;
  if (!parsed.error && type != Type::table) {
    parsed.error.emplace("not_an_object",
                         fmt::format("a request is a JSON object, found: {}", reference::type_name(type)),
                         "");
  }
  return parsed;
}

}  // namespace halfway::reports
