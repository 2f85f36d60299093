#include "reference/scene/text/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace halfway::reference {
namespace {

constexpr std::size_t kLongestShown = 60;

/// A message is read up to its first null character, which a text of TOML or JSON may have.
std::string without_nulls(std::string text) {
  for (std::size_t at = text.find('\0'); at != std::string::npos; at = text.find('\0', at))
    text.replace(at, 1, "\\u0000");
  return text;
}

}  // namespace

const char* type_name(DocumentNode::Type type) {
  using Type = DocumentNode::Type;
  switch (type) {
    case Type::table:
      return "a table";
    case Type::array:
      return "an array";
    case Type::text:
      return "a text";
    case Type::number:
      return "a number";
    case Type::boolean:
      return "a boolean";
    case Type::date:
      return "a date or time";
    default:
      return "null";
  }
}

std::string shortened(std::string text) {
  text = without_nulls(std::move(text));
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() <= kLongestShown) return text;
  std::size_t end = kLongestShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::vector<std::size_t> way_to(const Document& document, std::size_t place) {
  const auto& nodes = document.nodes;
  std::vector<std::size_t> way;
  for (std::size_t holder = 0; holder != place; holder = way.back()) {
    std::size_t item = holder + 1;
    while (nodes[item].end != 0 && nodes[item].end <= place) item = nodes[item].end;
    way.push_back(item);
  }
  return way;
}

std::string path_of(const Document& document, std::size_t place) {
  const auto& nodes = document.nodes;
  std::string path;
  std::size_t holder = 0;
  for (const std::size_t item : way_to(document, place)) {
    if (nodes[holder].type == DocumentNode::Type::array) {
      int index = document.dialect.first_index;
      for (std::size_t before = holder + 1; before != item; before = nodes[before].end) ++index;
      path += fmt::format("[{}]", index);
    } else {
      path +=
          (path.empty() ? "" : ".") + without_nulls(std::string(nodes[item].key.substr(0, kLongestShown)));
    }
    holder = item;
  }
  return path;
}

std::string shown(const Document& document, std::size_t place) {
  using Type = DocumentNode::Type;
  const DocumentNode& node = document.nodes[place];
  switch (node.type) {
    case Type::text:
      return shortened(fmt::format("\"{}\"", node.text));
    case Type::boolean:
      return node.boolean ? "true" : "false";
    case Type::number:
    case Type::date:
      return shortened(std::string(node.text));
    case Type::array:
      break;
    default:
      return type_name(node.type);
  }
  std::string list;
  for (std::size_t item = place + 1; item < node.end; item = document.nodes[item].end) {
    list += (list.empty() ? "" : ", ") + shown(document, item);
    if (list.size() > kLongestShown) break;
  }
  return shortened("[" + list + "]");
}

}  // namespace halfway::reference
