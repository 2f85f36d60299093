#include "reference/scene/document.hpp"

#include <algorithm>

namespace halfway::reference {
namespace {

constexpr std::size_t kLongestShown = 60;

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
  std::replace(text.begin(), text.end(), '\n', ' ');
  if (text.size() <= kLongestShown) return text;
  std::size_t end = kLongestShown;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string shown(const DocumentNode& node) {
  using Type = DocumentNode::Type;
  switch (node.type) {
    case Type::text:
      return shortened("\"" + node.text + "\"");
    case Type::boolean:
      return node.boolean ? "true" : "false";
    case Type::number:
    case Type::date:
      return shortened(node.text);
    case Type::array:
      break;
    default:
      return type_name(node.type);
  }
  std::string list;
  for (const DocumentNode& item : node.items) {
    list += (list.empty() ? "" : ", ") + shown(item);
    if (list.size() > kLongestShown) break;
  }
  return shortened("[" + list + "]");
}

}  // namespace halfway::reference
