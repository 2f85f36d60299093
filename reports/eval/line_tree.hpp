// One line's tree as it grows, in the order of the text: bounded in depth and size, no key twice.
#pragma once

#include "reference/scene/text/document.hpp"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace halfway::reports {

inline constexpr std::size_t kMostValues = 1000000;  ///< of one line; a pose has 21

/// What a parser of JSON tells, from left to right. Texts are the caller's, and have to outlive the document.
/// Throws Refusal: too_deep, too_many_values, duplicate_key, not_finite.
class LineTree {
 public:
  explicit LineTree(reference::Document& document) : document_(&document) {}

  void key(std::string_view name) { key_ = name; }  ///< of the value to come
  void add_nothing() { add(Type::nothing); }
  void add_boolean(bool value) { add(Type::boolean).boolean = value; }
  void add_text(std::string_view text) { add(Type::text).text = text; }
  void add_number(double value, std::string_view written) {
    reference::DocumentNode& node = add(Type::number);
    node.number = value;
    node.text = written;
  }
  [[noreturn]] void refuse_overflow();  ///< the number to come has no double

  void open_table() { open(Type::table); }
  void open_array() { open(Type::array); }
  void close_table();
  void close_array() { close(); }

 private:
  using Type = reference::DocumentNode::Type;
  using Member = std::pair<std::string_view, std::size_t>;

  reference::DocumentNode& add(Type type) {
    if (document_->nodes.size() == kMostValues) refuse_more();
    return document_->add(type, std::exchange(key_, {}));
  }
  [[noreturn]] void refuse_more() const;
  void open(Type type);
  void close();
  void refuse_twins(std::size_t table);

  reference::Document* document_;
  std::string_view key_{};
  std::vector<std::size_t> open_{};
  std::vector<Member> members_{};  ///< of the object that is closed: one memory for all
};

/// The top-level "id" as JSON, its numbers as they came: one may be larger than any integer type. null where
/// there is none, or it broke off.
std::string id_of(const reference::Document& document);

}  // namespace halfway::reports
