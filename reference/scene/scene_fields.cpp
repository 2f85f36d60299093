#include "reference/scene/scene_fields.hpp"

#include "reference/scene/scene.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

const char* type_name(const TomlNode& node) {
  switch (node.type) {
    case TomlNode::Type::table:
      return "a table";
    case TomlNode::Type::array:
      return "an array";
    case TomlNode::Type::text:
      return "a text";
    case TomlNode::Type::number:
      return "a number";
    case TomlNode::Type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

}  // namespace

void Field::refuse_at(int line, const std::string& what_is, const std::string& what,
                      const std::string& allowed) const {
  throw SceneError(fmt::format("{}:{}: {}: {}; allowed: {}", *file_, line, what_is, what, allowed));
}

void Field::refuse(const std::string& what, const std::string& allowed) const {
  refuse_at(node_->line, key_.empty() ? "the file" : fmt::format("{} = {}", key_, node_->shown), what,
            allowed);
}

void Field::expect(TomlNode::Type type, const std::string& allowed) const {
  if (node_->type != type) refuse(fmt::format("is {}", type_name(*node_)), allowed);
}

void Field::has_only(std::initializer_list<const char*> allowed) const {
  expect(TomlNode::Type::table, fmt::format("a table with {}", fmt::join(allowed, ", ")));
  for (const std::string& key : node_->keys) {
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    find(key)->refuse("is not a known key", fmt::format("{}", fmt::join(allowed, ", ")));
  }
}

std::optional<Field> Field::find(const std::string& key) const {
  const auto it = std::find(node_->keys.begin(), node_->keys.end(), key);
  if (it == node_->keys.end()) return std::nullopt;
  const auto& node = node_->items[std::size_t(it - node_->keys.begin())];
  return Field(node, key_.empty() ? key : key_ + "." + key, *file_);
}

Field Field::at(const std::string& key, const std::string& allowed) const {
  expect(TomlNode::Type::table, "a table with " + key);
  if (const auto field = find(key)) return *field;
  refuse_at(node_->line, fmt::format("{} = nothing", key_.empty() ? key : key_ + "." + key), "is missing",
            allowed);
}

std::vector<std::string> Field::keys() const {
  expect(TomlNode::Type::table, "a table");
  return node_->keys;
}

std::vector<Field> Field::items(const std::string& allowed) const {
  expect(TomlNode::Type::array, allowed);
  std::vector<Field> out;
  for (std::size_t i = 0; i < node_->items.size(); ++i) {
    out.emplace_back(node_->items[i], fmt::format("{}[{}]", key_, i + 1), *file_);
  }
  return out;
}

std::string Field::text() const {
  expect(TomlNode::Type::text, "a text that is not empty");
  if (node_->text.empty()) refuse("is empty", "a text that is not empty");
  return node_->text;
}

std::string Field::text_or(const std::string& key) const {
  const auto field = find(key);
  return field ? field->text() : "";
}

bool Field::boolean() const {
  expect(TomlNode::Type::boolean, "true, false");
  return node_->boolean;
}

double Field::number() const {
  expect(TomlNode::Type::number, "a finite number");
  if (!std::isfinite(node_->number)) refuse("is not finite", "a finite number");
  return node_->number;
}

double Field::positive() const {
  const double value = number();
  if (value <= 0) refuse("is not positive", "a number > 0");
  return value;
}

int Field::integer(int low, int high) const {
  const std::string allowed = fmt::format("an integer from {} to {}", low, high);
  expect(TomlNode::Type::number, allowed);
  if (!node_->is_integer) refuse("is not an integer", allowed);
  if (!(node_->number >= low && node_->number <= high)) refuse("is out of range", allowed);
  return int(node_->number);
}

std::string Field::one_of(const std::vector<std::string>& names) const {
  const std::string allowed = fmt::format("{}", fmt::join(names, ", "));
  expect(TomlNode::Type::text, allowed);
  if (std::find(names.begin(), names.end(), node_->text) == names.end())
    refuse("is not a known name", allowed);
  return node_->text;
}

std::vector<std::string> Field::distinct(const std::vector<std::string>& names) const {
  std::vector<std::string> out;
  for (const Field& item : items(fmt::format("an array of {}", fmt::join(names, ", ")))) {
    const std::string name = item.one_of(names);
    if (std::find(out.begin(), out.end(), name) != out.end()) item.refuse("is named twice", "each name once");
    out.push_back(name);
  }
  return out;
}

std::vector<double> Field::distinct_numbers() const {
  std::vector<double> out;
  for (const Field& item : items("an array of numbers")) {
    const double value = item.number();
    if (std::find(out.begin(), out.end(), value) != out.end())
      item.refuse("is named twice", "each number once");
    out.push_back(value);
  }
  return out;
}

Eigen::VectorXd Field::vector(int size, const std::string& allowed) const {
  const auto entries = items(allowed);
  if (int(entries.size()) != size) refuse(fmt::format("has {} entries", entries.size()), allowed);
  Eigen::VectorXd out(size);
  for (int i = 0; i < size; ++i) out(i) = entries[std::size_t(i)].number();
  return out;
}

Eigen::MatrixXd Field::square_matrix(int size, const std::string& allowed) const {
  const auto rows = items(allowed);
  if (int(rows.size()) != size) refuse(fmt::format("has {} rows", rows.size()), allowed);
  Eigen::MatrixXd out(size, size);
  for (int i = 0; i < size; ++i) out.row(i) = rows[std::size_t(i)].vector(size, allowed).transpose();
  return out;
}

}  // namespace halfway::reference
