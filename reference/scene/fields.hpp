// Checked access to the fields of a document: every getter says what is wrong, where, and what is allowed.
#pragma once

#include "reference/scene/dimensions.hpp"
#include "reference/scene/document.hpp"

#include <Eigen/Core>

#include <initializer_list>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

using Names = std::vector<std::string_view>;

/// Names, however they are held: good until the end of the call.
class NameView : public std::span<const std::string_view> {
 public:
  NameView(const Names& names) : span(names) {}
  NameView(std::initializer_list<std::string_view> names) : span(names.begin(), names.size()) {}
};

/// One value of a document, which knows its key path, e.g. joint.law.stiffness[2]: a place to look at, with
/// words and paths made where something is wrong. All getters throw Refusal; its code is in brackets where it
/// is not wrong_type.
///
/// A getter of numbers that is told their dimension takes each also as a text with a unit, "12 mm", and an
/// array of them also as { values = [...], unit = "mm" } [unknown_unit, wrong_unit]; what it returns is in
/// SI.
class Field {
 public:
  explicit Field(Document& document) : Field(document, 0) {}

  [[noreturn]] void refuse(const std::string& what, std::string_view allowed,
                           const char* code = "wrong_value") const;
  /// Accepted, but not as it stands: said once, by the door.
  void note(const std::string& what) const;
  const Dialect& dialect() const { return document_->dialect; }

  // Tables.
  void has_only(NameView keys) const;  ///< [unknown_key]
  std::optional<Field> find(std::string_view key) const;
  Field at(std::string_view key, std::string_view allowed) const;  ///< [missing_key]
  std::vector<std::string> keys() const;

  // Arrays.
  class Items;
  Items items(std::string_view allowed = "an array") const;
  bool is_array() const { return node().type == DocumentNode::Type::array; }
  bool is_table() const { return node().type == DocumentNode::Type::table; }
  bool holds_arrays() const;  ///< also as { values, unit }
  bool is_text() const { return node().type == DocumentNode::Type::text; }
  bool says(std::string_view text) const { return is_text() && node().text == text; }

  // Values.
  std::string text() const;
  std::string text_or(std::string_view key) const;  ///< of a table: the text at key, or ""
  bool boolean() const;
  double number(const Dimension& dimension = {}) const;  ///< finite
  double positive(const Dimension& dimension = {}) const;
  int integer(int low, int high) const;
  std::string one_of(NameView names, const char* code = "unknown_name") const;
  std::vector<std::string> distinct(NameView names) const;
  std::vector<double> distinct_numbers() const;
  Eigen::VectorXd vector(int size, std::string_view allowed,
                         const Dimensions& dimensions = {}) const;  ///< [wrong_shape]
  Eigen::MatrixXd square_matrix(int size, std::string_view allowed,
                                const MatrixDimensions& dimensions = {}) const;  ///< [wrong_shape]
  std::vector<double> numbers(std::string_view allowed, const Dimension& dimension) const;
  /// The same of a size that is known: nothing is allocated.
  template <int size>
  Eigen::Matrix<double, size, 1> vector(std::string_view allowed, const Dimensions& dimensions = {}) const {
    Eigen::Matrix<double, size, 1> out;
    read_numbers(size, allowed, dimensions, out.data());
    return out;
  }

 private:
  Field(Document& document, std::size_t place) : document_(&document), place_(place) {}
  const DocumentNode& node() const { return document_->nodes[place_]; }
  void expect(DocumentNode::Type type, std::string_view allowed) const {
    if (node().type != type) refuse_type(allowed);
  }
  [[noreturn]] void refuse_type(std::string_view allowed) const;
  std::size_t count() const;
  void has_size(int size, const char* of_what, std::string_view allowed) const;
  void read_numbers(int size, std::string_view allowed, const Dimensions& dimensions, double* out) const;

  // Units.
  struct SharedUnit {
    Unit unit;
    std::string_view text;
  };
  struct Values;
  /// An array with the unit of all of its numbers: { values, unit }, where a unit may be; or itself.
  Values values(bool may_have_unit) const;
  void read_row(int size, std::string_view allowed, const Dimensions& dimensions,
                const std::optional<SharedUnit>& unit, double* out) const;
  double entry(const Dimension& dimension, const std::optional<SharedUnit>& unit) const;
  double quantity(const Dimension& dimension) const;
  Unit unit_of(std::string_view text) const;
  void check_fits(const Unit& unit, std::string_view text, const Dimension& dimension) const;
  double in_si_of(std::string_view decimal, const Unit& unit) const;

  std::string path(std::string_view key) const;

  Document* document_;
  std::size_t place_;
};

/// The items of an array, or of a table, in their order.
class Field::Items {
 public:
  class Iterator {
   public:
    using difference_type = std::ptrdiff_t;
    using value_type = Field;
    using reference = Field;
    using pointer = void;
    using iterator_category = std::input_iterator_tag;
    Iterator(Document& document, std::size_t place) : document_(&document), place_(place) {}
    Field operator*() const { return {*document_, place_}; }
    Iterator& operator++() {
      place_ = document_->nodes[place_].end;
      return *this;
    }
    bool operator==(const Iterator& other) const { return place_ == other.place_; }

   private:
    Document* document_;
    std::size_t place_;
  };

  explicit Items(const Field& holder) : holder_(holder) {}
  Iterator begin() const { return {*holder_.document_, holder_.place_ + 1}; }
  Iterator end() const { return {*holder_.document_, holder_.node().end}; }

 private:
  Field holder_;
};

struct Field::Values {
  Field array;
  std::optional<SharedUnit> unit;
};

inline bool Field::holds_arrays() const {
  if (is_table()) {
    const auto values = find("values");
    return values && values->is_array() && values->holds_arrays();
  }
  return is_array() && node().end > place_ + 1 &&
         document_->nodes[place_ + 1].type == DocumentNode::Type::array;
}

}  // namespace halfway::reference
