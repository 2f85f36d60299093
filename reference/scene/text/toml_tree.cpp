#include "reference/scene/text/toml_tree.hpp"

#include "reference/scene/text/toml_depth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <tuple>

// toml++ 3.3 asserts on some malformed input (a missing value) that it refuses properly by itself. With
// NDEBUG it turns these asserts into assumptions for the optimiser, which is worse: here they are nothing in
// every build.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#define TOML_MAX_NESTED_VALUES 32  // kDeepestNesting
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace halfway::reference {
namespace {

constexpr std::size_t kLargestFile = 1 << 20;
/// As a person would type it: 0.1, not 0.10000000000000001.
std::string written(const toml::node& node) {
  std::ostringstream date;
  if (const auto integer = node.value_exact<int64_t>()) return fmt::format("{}", *integer);
  if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
  node.visit([&](const auto& value) { date << value; });
  return date.str();
}

[[noreturn]] void refuse_depth(int line) {
  throw Refusal(
      "too_deep",
      fmt::format("this line: is nested deeper than {0} levels; allowed: up to {0}", kDeepestNesting), "",
      line);
}

void add(const toml::node& node, std::string_view key, int depth, Document& out);

/// toml++ orders keys by name; messages and reports want the order of the file.
void add_entries(const toml::table& table, int depth, Document& out) {
  using Entry = std::pair<std::string_view, const toml::node*>;
  std::vector<Entry> entries;
  for (const auto& [key, value] : table) entries.emplace_back(key.str(), &value);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const auto x = a.second->source().begin, y = b.second->source().begin;
    return std::tie(x.line, x.column) < std::tie(y.line, y.column);
  });
  for (const auto& [key, value] : entries) add(*value, out.keep(std::string(key)), depth + 1, out);
}

/// A value that holds no other.
void add_value(const toml::node& node, std::string_view key, int line, Document& out) {
  using Type = DocumentNode::Type;
  const auto add = [&](Type type) -> DocumentNode& {
    DocumentNode& value = out.add(type, key);
    value.line = line;
    return value;
  };
  if (const auto text = node.value_exact<std::string>()) {
    add(Type::text).text = out.keep(*text);
  } else if (node.is_number()) {
    DocumentNode& value = add(Type::number);
    // toml++ has no double for an integer beyond 2^53.
    value.number = node.is_integer() ? double(*node.value_exact<int64_t>()) : *node.value_exact<double>();
    value.is_integer = node.is_integer();
    value.text = out.keep(written(node));
  } else if (const auto boolean = node.value_exact<bool>()) {
    add(Type::boolean).boolean = *boolean;
  } else {
    add(Type::date).text = out.keep(written(node));
  }
}

void add(const toml::node& node, std::string_view key, int depth, Document& out) {
  const int line = std::max<int>(1, int(node.source().begin.line));
  if (depth > kDeepestNesting) refuse_depth(line);
  const auto* table = node.as_table();
  const auto* array = node.as_array();
  if (!table && !array) return add_value(node, key, line, out);
  const std::size_t place = out.nodes.size();
  out.add(table ? DocumentNode::Type::table : DocumentNode::Type::array, key).line = line;
  if (table) add_entries(*table, depth, out);
  if (array) {
    for (const auto& item : *array) add(item, {}, depth + 1, out);
  }
  out.close(place);
}

std::string content(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& what) {
    throw SceneError(
        fmt::format("{}: {}; allowed: a readable TOML file of at most 1 MB", file.string(), what));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) refuse("is a folder");
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) refuse(fmt::format("cannot be read ({})", std::strerror(errno)));
  std::string text(kLargestFile + 1, '\0');
  in.read(text.data(), std::streamsize(text.size()));
  if (in.bad()) refuse("broke off while it was read");
  text.resize(std::size_t(in.gcount()));
  if (text.size() > kLargestFile) refuse("is too long");
  return text;
}

/// A line of what may not be text at all: other bytes than ASCII are shown as '?'.
std::string line_of(const std::string& text, std::size_t number) {
  std::istringstream in(text);
  std::string line;
  for (std::size_t i = 0; i < number; ++i) std::getline(in, line);
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c > 0x7E; }, '?');
  return shortened(line);
}

}  // namespace

void read_toml_text(const std::string& text, const std::string& name, Document& out) {
  if (const int line = line_of_deep_key(text)) refuse_depth(line);
  try {
    add(toml::parse(text, name), {}, 1, out);
  } catch (const toml::parse_error& error) {
    const auto line = std::max<toml::source_index>(1, error.source().begin.line);
    throw SceneError(fmt::format("{}:{}: {}: is not TOML ({}); allowed: TOML 1.0", name, line,
                                 line_of(text, line), shortened(std::string(error.description()))));
  }
}

void read_toml(const std::filesystem::path& file, Document& out) {
  read_toml_text(content(file), file.string(), out);
}

}  // namespace halfway::reference
