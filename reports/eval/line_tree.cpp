#include "reports/eval/line_tree.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace halfway::reports {

using reference::Document;
using reference::Refusal;
using Type = reference::DocumentNode::Type;

void LineTree::refuse_more() const {
  throw Refusal("too_many_values", fmt::format("a line of more than {} values", kMostValues), "");
}

void LineTree::refuse_overflow() {
  add(Type::number).end = 0;  // it is not whole
  throw Refusal("not_finite", "a number is too large for double precision",
                path_of(*document_, document_->nodes.size() - 1));
}

void LineTree::open(Type type) {
  if (open_.size() == std::size_t(reference::kDeepestNesting)) {
    throw Refusal("too_deep", fmt::format("nested deeper than {} levels", reference::kDeepestNesting), "");
  }
  add(type);
  open_.push_back(document_->nodes.size() - 1);
}

void LineTree::close() {
  document_->close(open_.back());
  open_.pop_back();
}

void LineTree::close_table() {
  refuse_twins(open_.back());
  close();
}

void LineTree::refuse_twins(std::size_t table) {
  const auto& nodes = document_->nodes;
  members_.clear();
  for (std::size_t item = table + 1; item < nodes.size(); item = nodes[item].end)
    members_.emplace_back(nodes[item].key, item);
  std::ranges::sort(members_);
  const auto twin = std::ranges::adjacent_find(members_, {}, &Member::first);
  if (twin == members_.end()) return;
  throw Refusal(
      "duplicate_key",
      fmt::format("'{}' stands twice in one object", reference::shortened(std::string(twin->first))),
      path_of(*document_, std::next(twin)->second));
}

namespace {

std::string quoted(std::string_view text) { return nlohmann::json(text).dump(); }

std::string json_text(const Document& document, std::size_t place) {
  const auto& node = document.nodes[place];
  switch (node.type) {
    case Type::text:
      return quoted(node.text);
    case Type::number:
      return std::string(node.text);
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
  for (std::size_t item = place + 1; item < node.end; item = document.nodes[item].end) {
    if (!out.empty()) out += ',';
    if (is_table) out += quoted(document.nodes[item].key) + ':';
    out += json_text(document, item);
  }
  return is_table ? '{' + out + '}' : '[' + out + ']';
}

}  // namespace

std::string id_of(const Document& document) {
  const auto& nodes = document.nodes;
  if (nodes.empty() || nodes.front().type != Type::table) return "null";
  for (std::size_t item = 1; item < nodes.size() && nodes[item].end != 0; item = nodes[item].end) {
    if (nodes[item].key == "id") return json_text(document, item);
  }
  return "null";
}

}  // namespace halfway::reports
