// Checked access to the fields of a scene file: every getter says what is wrong, where, and what is allowed.
#pragma once

#include "reference/scene/toml_tree.hpp"

#include <Eigen/Core>

#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace halfway::reference {

/// One value of the file with its key path, e.g. joint.law.stiffness[2]. All getters throw SceneError.
class Field {
 public:
  Field(const TomlNode& node, std::string key, const std::string& file)
      : node_(&node), key_(std::move(key)), file_(&file) {}

  /// "FILE:LINE: KEY = VALUE: WHAT; allowed: ALLOWED".
  [[noreturn]] void refuse(const std::string& what, const std::string& allowed) const;
  const std::string& key() const { return key_; }

  // Tables.
  void has_only(std::initializer_list<const char*> keys) const;
  std::optional<Field> find(const std::string& key) const;
  Field at(const std::string& key, const std::string& allowed) const;
  std::vector<std::string> keys() const;

  // Arrays.
  std::vector<Field> items(const std::string& allowed = "an array") const;
  bool is_array() const { return node_->type == TomlNode::Type::array; }
  bool is_text() const { return node_->type == TomlNode::Type::text; }

  // Values.
  std::string text() const;
  std::string text_or(const std::string& key) const;  ///< of a table: the text at key, or ""
  bool boolean() const;
  double number() const;  ///< finite
  double positive() const;
  int integer(int low, int high) const;
  std::string one_of(const std::vector<std::string>& names) const;
  std::vector<std::string> distinct(const std::vector<std::string>& names) const;
  std::vector<double> distinct_numbers() const;
  Eigen::VectorXd vector(int size, const std::string& allowed) const;
  Eigen::MatrixXd square_matrix(int size, const std::string& allowed) const;

 private:
  [[noreturn]] void refuse_at(int line, const std::string& what_is, const std::string& what,
                              const std::string& allowed) const;
  void expect(TomlNode::Type type, const std::string& allowed) const;

  const TomlNode* node_;
  std::string key_;
  const std::string* file_;
};

}  // namespace halfway::reference
