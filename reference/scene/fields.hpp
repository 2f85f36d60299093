// Checked access to the fields of a document: every getter says what is wrong, where, and what is allowed.
#pragma once

#include "reference/scene/document.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

using Names = std::vector<std::string_view>;

/// One value of a document with its key path, e.g. joint.law.stiffness[2]. All getters throw Refusal;
/// its code is in brackets where it is not wrong_type.
class Field {
 public:
  explicit Field(Document& document) : Field(document.root, "", document) {}

  [[noreturn]] void refuse(const std::string& what, const std::string& allowed,
                           const char* code = "wrong_value") const;
  /// Accepted, but not as it stands: said once, by the door.
  void note(const std::string& what) const;
  const std::string& key() const { return key_; }
  const Dialect& dialect() const { return document_->dialect; }

  // Tables.
  void has_only(const Names& keys) const;  ///< [unknown_key]
  std::optional<Field> find(std::string_view key) const;
  Field at(std::string_view key, const std::string& allowed) const;  ///< [missing_key]
  std::vector<std::string> keys() const;

  // Arrays.
  std::vector<Field> items(const std::string& allowed = "an array") const;
  bool is_array() const { return node_->type == DocumentNode::Type::array; }
  bool holds_arrays() const { return is_array() && !node_->items.empty() && item(0).is_array(); }
  bool is_text() const { return node_->type == DocumentNode::Type::text; }
  bool says(std::string_view text) const { return is_text() && node_->text == text; }

  // Values.
  std::string text() const;
  std::string text_or(const std::string& key) const;  ///< of a table: the text at key, or ""
  bool boolean() const;
  double number() const;  ///< finite
  double positive() const;
  int integer(int low, int high) const;
  std::string one_of(const Names& names, const char* code = "unknown_name") const;
  std::vector<std::string> distinct(const Names& names) const;
  std::vector<double> distinct_numbers() const;
  Eigen::VectorXd vector(int size, const std::string& allowed) const;         ///< [wrong_shape]
  Eigen::MatrixXd square_matrix(int size, const std::string& allowed) const;  ///< [wrong_shape]

 private:
  Field(const DocumentNode& node, std::string key, Document& document)
      : node_(&node), key_(std::move(key)), document_(&document) {}
  void expect(DocumentNode::Type type, const std::string& allowed) const;
  void has_size(int size, const char* of_what, const std::string& allowed) const;
  std::string path(std::string_view key) const;
  Field item(std::size_t i) const;

  const DocumentNode* node_;
  std::string key_;
  Document* document_;
};

}  // namespace halfway::reference
