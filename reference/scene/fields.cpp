#include "reference/scene/fields.hpp"

#include "reference/scene/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference {

void Field::refuse(const std::string& what, const std::string& allowed, const char* code) const {
  const std::string value =
      key_.empty() ? std::string(dialect().whole) : fmt::format("{} = {}", key_, shown(*node_));
  throw Refusal(code, fmt::format("{}: {}; allowed: {}", value, what, allowed), key_, node_->line);
}

void Field::note(const std::string& what) const {
  document_->notes.push_back(fmt::format("{} {}", key_, what));
}

std::string Field::path(std::string_view key) const {
  const std::string name = key.size() > 60 ? std::string(key.substr(0, 60)) : std::string(key);
  return key_.empty() ? name : fmt::format("{}.{}", key_, name);
}

Field Field::item(std::size_t i) const {
  return {node_->items[i], fmt::format("{}[{}]", key_, i + std::size_t(dialect().first_index)), *document_};
}

void Field::expect(DocumentNode::Type type, const std::string& allowed) const {
  if (node_->type != type) refuse(fmt::format("is {}", type_name(node_->type)), allowed, "wrong_type");
}

void Field::has_size(int size, const char* of_what, const std::string& allowed) const {
  expect(DocumentNode::Type::array, allowed);
  if (int(node_->items.size()) == size) return;
  refuse(fmt::format("has {} {}", node_->items.size(), of_what), allowed, "wrong_shape");
}

void Field::has_only(const Names& allowed) const {
  expect(DocumentNode::Type::table, fmt::format("a table with {}", fmt::join(allowed, ", ")));
  for (std::size_t i = 0; i < node_->keys.size(); ++i) {
    const std::string& key = node_->keys[i];
    if (std::find(allowed.begin(), allowed.end(), key) != allowed.end()) continue;
    Field(node_->items[i], path(key), *document_)
        .refuse("is not a known key" + did_you_mean(key, allowed),
                fmt::format("{}", fmt::join(allowed, ", ")), "unknown_key");
  }
}

std::optional<Field> Field::find(std::string_view key) const {
  const auto it = std::find(node_->keys.begin(), node_->keys.end(), key);
  if (it == node_->keys.end()) return std::nullopt;
  return Field(node_->items[std::size_t(it - node_->keys.begin())], path(key), *document_);
}

Field Field::at(std::string_view key, const std::string& allowed) const {
  expect(DocumentNode::Type::table, fmt::format("a table with {}", key));
  if (const auto field = find(key)) return *field;
  throw Refusal("missing_key", fmt::format("{} = nothing: is missing; allowed: {}", path(key), allowed),
                path(key), node_->line);
}

std::vector<std::string> Field::keys() const {
  expect(DocumentNode::Type::table, "a table");
  return node_->keys;
}

std::vector<Field> Field::items(const std::string& allowed) const {
  expect(DocumentNode::Type::array, allowed);
  std::vector<Field> out;
  for (std::size_t i = 0; i < node_->items.size(); ++i) out.push_back(item(i));
  return out;
}

std::string Field::text() const {
  expect(DocumentNode::Type::text, "a text that is not empty");
  if (node_->text.empty()) refuse("is empty", "a text that is not empty");
  return node_->text;
}

std::string Field::text_or(const std::string& key) const {
  const auto field = find(key);
  return field ? field->text() : "";
}

bool Field::boolean() const {
  expect(DocumentNode::Type::boolean, "true, false");
  return node_->boolean;
}

double Field::number() const {
  expect(DocumentNode::Type::number, "a finite number");
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
  expect(DocumentNode::Type::number, allowed);
  if (!node_->is_integer) refuse("is not an integer", allowed);
  if (!(node_->number >= low && node_->number <= high)) refuse("is out of range", allowed);
  return int(node_->number);
}

std::string Field::one_of(const Names& names, const char* code) const {
  const std::string allowed = fmt::format("{}", fmt::join(names, ", "));
  expect(DocumentNode::Type::text, allowed);
  if (std::find(names.begin(), names.end(), node_->text) == names.end())
    refuse("is not a known name" + did_you_mean(node_->text, names), allowed, code);
  return node_->text;
}

std::vector<std::string> Field::distinct(const Names& names) const {
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
  has_size(size, "entries", allowed);
  Eigen::VectorXd out(size);
  for (int i = 0; i < size; ++i) out(i) = item(std::size_t(i)).number();
  return out;
}

Eigen::MatrixXd Field::square_matrix(int size, const std::string& allowed) const {
  has_size(size, "rows", allowed);
  Eigen::MatrixXd out(size, size);
  for (int i = 0; i < size; ++i) out.row(i) = item(std::size_t(i)).vector(size, allowed).transpose();
  return out;
}

}  // namespace halfway::reference
