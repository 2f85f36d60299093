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

std::string with_unit(const Dimension& dimension) {
  return fmt::format("a number, {}, or a text of a number and a unit: {}", si_unit(dimension),
                     example_units(dimension));
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

double Field::number(const Dimension& dimension) const {
  if (is_text() && dimension != Dimension{}) return quantity(dimension);
  expect(DocumentNode::Type::number, "a finite number");
  if (!std::isfinite(node().number)) refuse("is not finite", "a finite number");
  return node().number;
}

double Field::positive(const Dimension& dimension) const {
  const double value = number(dimension);
  if (value <= 0) refuse("is not positive", "a number > 0");
  return value;
}

double Field::quantity(const Dimension& dimension) const {
  const auto [number, unit_text] = split_quantity(node().text);
  if (number.empty()) refuse_type(with_unit(dimension));
  if (unit_text.empty()) refuse("is a text without a unit", with_unit(dimension), "wrong_unit");
  const Unit unit = unit_of(unit_text);
  check_fits(unit, unit_text, dimension);
  return in_si_of(number, unit);
}

/// Of the text of a unit, in whatever field it stands.
Unit Field::unit_of(std::string_view text) const {
  try {
    return read_unit(text);
  } catch (const NoUnit& error) {
    const Names names(unit_names());
    refuse(fmt::format("has the unit '{}', which {}{}", shortened(std::string(text)), error.what(),
                       error.name.empty() ? "" : did_you_mean(error.name, names)),
           fmt::format("{}, and products and powers of them such as N m/deg, deg/(N m), 1/mm^2",
                       fmt::join(names, ", ")),
           "unknown_unit");
  }
}

void Field::check_fits(const Unit& unit, std::string_view text, const Dimension& dimension) const {
  if (fits(unit.dimension, dimension)) return;
  refuse(fmt::format("is in {} ({} in SI) where {} is needed", shortened(std::string(text)),
                     si_unit(unit.dimension), si_unit(dimension)),
         with_unit(dimension), "wrong_unit");
}

double Field::in_si_of(std::string_view decimal, const Unit& unit) const {
  const double value = in_si(decimal, unit);
  if (!std::isfinite(value)) refuse("is not finite", "a finite number");
  return value;
}

double Field::entry(const Dimension& dimension, const std::optional<SharedUnit>& shared) const {
  if (!shared) return number(dimension);
  if (is_text())
    refuse("has a unit beside that of all values",
           "plain numbers, or texts with units without { values, unit }", "wrong_unit");
  number();
  check_fits(shared->unit, shared->text, dimension);
  return in_si_of(node().text, shared->unit);
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

Field::Values Field::values(bool may_have_unit) const {
  if (!may_have_unit || !is_table()) return {*this, std::nullopt};
  has_only({"values", "unit"});
  const std::string_view allowed = "the unit of all values, such as \"mm\"";
  const Field unit = at("unit", allowed);
  unit.expect(DocumentNode::Type::text, allowed);
  return {at("values", "an array of numbers"), SharedUnit{unit.unit_of(unit.node().text), unit.node().text}};
}

void Field::read_row(int size, std::string_view allowed, const Dimensions& dimensions,
                     const std::optional<SharedUnit>& unit, double* out) const {
  has_size(size, "entries", allowed);
  int i = 0;
  for (const Field item : Items(*this)) *out++ = item.entry(dimensions[i++], unit);
}

void Field::read_numbers(int size, std::string_view allowed, const Dimensions& dimensions,
                         double* out) const {
  const Values all = values(dimensions != Dimensions{});
  all.array.read_row(size, allowed, dimensions, all.unit, out);
}

Eigen::VectorXd Field::vector(int size, std::string_view allowed, const Dimensions& dimensions) const {
  Eigen::VectorXd out(size);
  read_numbers(size, allowed, dimensions, out.data());
  return out;
}

std::vector<double> Field::numbers(std::string_view allowed, const Dimension& dimension) const {
  const Values all = values(dimension != Dimension{});
  std::vector<double> out;
  for (const Field item : all.array.items(allowed)) out.push_back(item.entry(dimension, all.unit));
  return out;
}

Eigen::MatrixXd Field::square_matrix(int size, std::string_view allowed,
                                     const MatrixDimensions& dimensions) const {
  const Values all = values(dimensions != MatrixDimensions{});
  all.array.has_size(size, "rows", allowed);
  Eigen::MatrixXd out(size, size);
  Eigen::VectorXd row(size);
  int i = 0;
  for (const Field item : Items(all.array)) {
    item.read_row(size, allowed, dimensions[i], all.unit, row.data());
    out.row(i++) = row.transpose();
  }
  return out;
}

}  // namespace halfway::reference
