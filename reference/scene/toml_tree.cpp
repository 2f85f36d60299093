#include "reference/scene/toml_tree.hpp"

#include "reference/scene/scene.hpp"

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
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace halfway::reference {
namespace {

constexpr std::size_t kLargestFile = 1 << 20;
constexpr std::size_t kLongestShown = 60;

std::string shortened(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() <= kLongestShown) return text;
  std::size_t end = kLongestShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // whole UTF-8 characters
  return text.substr(0, end) + "...";
}

/// As a person would type it: 0.1, not 0.10000000000000001.
std::string shown(const toml::node& node, const TomlNode& read) {
  using Type = TomlNode::Type;
  std::ostringstream date;
  switch (read.type) {
    case Type::table:
      return "a table";
    case Type::number:
      return read.is_integer ? fmt::format("{}", *node.value<int64_t>()) : fmt::format("{}", read.number);
    case Type::boolean:
      return read.boolean ? "true" : "false";
    case Type::text:
      return shortened("\"" + read.text + "\"");
    case Type::array:
      break;
    case Type::date:
      node.visit([&](const auto& value) { date << value; });
      return date.str();
  }
  std::string list;
  for (const TomlNode& item : read.items) list += (list.empty() ? "" : ", ") + item.shown;
  return shortened("[" + list + "]");
}

TomlNode tree(const toml::node& node);

/// toml++ orders keys by name; messages and reports want the order of the file.
void add_entries(const toml::table& table, TomlNode& out) {
  using Entry = std::pair<std::string, const toml::node*>;
  std::vector<Entry> entries;
  for (const auto& [key, value] : table) entries.emplace_back(std::string(key.str()), &value);
  std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    const auto x = a.second->source().begin, y = b.second->source().begin;
    return std::tie(x.line, x.column) < std::tie(y.line, y.column);
  });
  for (const auto& [key, value] : entries) {
    out.keys.push_back(key);
    out.items.push_back(tree(*value));
  }
}

TomlNode tree(const toml::node& node) {
  using Type = TomlNode::Type;
  TomlNode out;
  out.line = std::max<int>(1, int(node.source().begin.line));
  if (const auto* table = node.as_table()) {
    add_entries(*table, out);
  } else if (const auto* array = node.as_array()) {
    out.type = Type::array;
    for (const auto& item : *array) out.items.push_back(tree(item));
  } else if (const auto text = node.value_exact<std::string>()) {
    out.type = Type::text;
    out.text = *text;
  } else if (node.is_number()) {
    out.type = Type::number;
    out.number = *node.value<double>();
    out.is_integer = node.is_integer();
  } else if (const auto boolean = node.value_exact<bool>()) {
    out.type = Type::boolean;
    out.boolean = *boolean;
  } else {
    out.type = Type::date;
  }
  out.shown = shown(node, out);
  return out;
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

TomlNode read_toml(const std::filesystem::path& file) {
  const std::string text = content(file);
  try {
    return tree(toml::parse(text, file.string()));
  } catch (const toml::parse_error& error) {
    const auto line = std::max<toml::source_index>(1, error.source().begin.line);
    throw SceneError(fmt::format("{}:{}: {}: is not TOML ({}); allowed: TOML 1.0", file.string(), line,
                                 line_of(text, line), shortened(std::string(error.description()))));
  }
}

}  // namespace halfway::reference
