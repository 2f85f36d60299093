#include "reference/scene/fields.hpp"

#include "reference/scene/names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace halfway::reference {

namespace {

/// Those of one joint, and some of poses that may be thousands.
constexpr std::size_t kMostNotes = 20;

std::string listed(NameView names) { return fmt::format("{}", fmt::join(names, ", ")); }

bool contains(NameView names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string did_you_mean_of(std::string_view name, NameView names) {
  return did_you_mean(name, Names(names.begin(), names.end()));
}

}  // namespace

void Field::refuse(const std::string& what, std::string_view allowed, const char* code) const {
  const std::string key = path_of(*document_, place_);
  const std::string value =
      key.empty() ? std::string(dialect().whole) : fmt::format("{} = {}", key, shown(*document_, place_));
  throw Refusal(code, fmt::format("{}: {}; allowed: {}", value, what, allowed), key, node().line);
}

void Field::refuse_type(std::string_view allowed) const {
  refuse(fmt::format("is {}", type_name(node().type)), allowed, "wrong_type");
}

void Field::note(const std::string& what) const {
  if (document_->notes.size() < kMostNotes)
    document_->notes.push_back(fmt::format("{} {}", path_of(*document_, place_), what));
  else
    ++document_->more_notes;
}

std::string Field::path(std::string_view key) const {
  const std::string own = path_of(*document_, place_);
  return own.empty() ? std::string(key) : fmt::format("{}.{}", own, key);
}

std::size_t Field::count() const {
  const Items all(*this);
  return std::size_t(std::distance(all.begin(), all.end()));
}

void Field::has_size(int size, const char* of_what, std::string_view allowed) const {
  expect(DocumentNode::Type::array, allowed);
  const std::size_t found = count();
  if (found != std::size_t(size)) refuse(fmt::format("has {} {}", found, of_what), allowed, "wrong_shape");
}

void Field::has_only(NameView allowed) const {
  if (node().type != DocumentNode::Type::table) refuse_type("a table with " + listed(allowed));
  for (const Field item : Items(*this)) {
    const std::string_view key = item.node().key;
    if (contains(allowed, key)) continue;
    item.refuse("is not a known key" + did_you_mean_of(key, allowed), listed(allowed), "unknown_key");
  }
}

std::optional<Field> Field::find(std::string_view key) const {
  for (const Field item : Items(*this)) {
    if (item.node().key == key) return item;
  }
  return std::nullopt;
}

Field Field::at(std::string_view key, std::string_view allowed) const {
  if (node().type != DocumentNode::Type::table) refuse_type(fmt::format("a table with {}", key));
  if (const auto field = find(key)) return *field;
  throw Refusal("missing_key", fmt::format("{} = nothing: is missing; allowed: {}", path(key), allowed),
                path(key), node().line);
}

std::vector<std::string> Field::keys() const {
  expect(DocumentNode::Type::table, "a table");
  std::vector<std::string> out;
  for (const Field item : Items(*this)) out.emplace_back(item.node().key);
  return out;
}

Field::Items Field::items(std::string_view allowed) const {
  expect(DocumentNode::Type::array, allowed);
  return Items(*this);
}

std::string Field::text() const {
  expect(DocumentNode::Type::text, "a text that is not empty");
  if (node().text.empty()) refuse("is empty", "a text that is not empty");
  return std::string(node().text);
}

std::string Field::text_or(std::string_view key) const {
  const auto field = find(key);
  return field ? field->text() : "";
}

bool Field::boolean() const {
  expect(DocumentNode::Type::boolean, "true, false");
  return node().boolean;
}

double Field::number() const {
  expect(DocumentNode::Type::number, "a finite number");
  if (!std::isfinite(node().number)) refuse("is not finite", "a finite number");
  return node().number;
}

double Field::positive() const {
  const double value = number();
  if (value <= 0) refuse("is not positive", "a number > 0");
  return value;
}

int Field::integer(int low, int high) const {
  const std::string allowed = fmt::format("an integer from {} to {}", low, high);
  expect(DocumentNode::Type::number, allowed);
  const bool has_digits_alone = node().text.find_first_not_of("-0123456789") == std::string_view::npos;
  if (!node().is_integer && !has_digits_alone) refuse("is not an integer", allowed);
  if (!(node().number >= low && node().number <= high)) refuse("is out of range", allowed);
  return int(node().number);
}

std::string Field::one_of(NameView names, const char* code) const {
  if (!is_text()) refuse_type(listed(names));
  if (!contains(names, node().text))
    refuse("is not a known name" + did_you_mean_of(node().text, names), listed(names), code);
  return std::string(node().text);
}

std::vector<std::string> Field::distinct(NameView names) const {
  if (!is_array()) refuse_type("an array of " + listed(names));
  std::vector<std::string> out;
  for (const Field item : Items(*this)) {
    const std::string name = item.one_of(names);
    if (std::find(out.begin(), out.end(), name) != out.end()) item.refuse("is named twice", "each name once");
    out.push_back(name);
  }
  return out;
}

std::vector<double> Field::distinct_numbers() const {
  std::vector<double> out;
  for (const Field item : items("an array of numbers")) {
    const double value = item.number();
    if (std::find(out.begin(), out.end(), value) != out.end())
      item.refuse("is named twice", "each number once");
    out.push_back(value);
  }
  return out;
}

void Field::read_numbers(int size, std::string_view allowed, double* out) const {
  has_size(size, "entries", allowed);
  for (const Field item : Items(*this)) *out++ = item.number();
}

Eigen::VectorXd Field::vector(int size, std::string_view allowed) const {
  Eigen::VectorXd out(size);
  read_numbers(size, allowed, out.data());
  return out;
}

Eigen::MatrixXd Field::square_matrix(int size, std::string_view allowed) const {
  has_size(size, "rows", allowed);
  Eigen::MatrixXd out(size, size);
  Eigen::Index i = 0;
  for (const Field row : Items(*this)) out.row(i++) = row.vector(size, allowed).transpose();
  return out;
}

}  // namespace halfway::reference
