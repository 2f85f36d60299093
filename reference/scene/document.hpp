// A scene file or a request as one plain tree, and what is wrong with a value of it: TOML and JSON are
// read by the same words and rules; the doors differ in how a refusal is printed.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

/// Tables and arrays inside each other, of either door: a joint needs five.
inline constexpr int kDeepestNesting = 32;

struct DocumentNode {
  enum class Type { table, array, text, number, boolean, date, nothing };
  Type type = Type::table;
  bool is_integer = false;  ///< a number written as integer
  bool boolean = false;
  int line = 1;
  double number = 0;
  std::string text{};                 ///< of a text; of a number or date as it was written
  std::vector<std::string> keys{};    ///< of a table, in the order of the file; one for each item
  std::vector<DocumentNode> items{};  ///< of a table or array
};

/// "a table", "a number" ...
const char* type_name(DocumentNode::Type type);

/// The value as a person would type it, shortened.
std::string shown(const DocumentNode& node);

/// Cut to 60 bytes, whole UTF-8 characters, on one line.
std::string shortened(std::string text);

/// Where the doors differ.
struct Dialect {
  const char* whole;      ///< what a message calls the document
  int first_index;        ///< of arrays in key paths
  const char* stiffness;  ///< of the words for it the one that a message misses
};
inline constexpr Dialect kScene{"the file", 1, "stiffness"};
inline constexpr Dialect kRequest{"the line", 0, "K"};

struct Document {
  DocumentNode root;
  Dialect dialect = kScene;
  std::vector<std::string> notes{};  ///< "KEY: what was accepted and changed"
};

/// What is wrong with one value: "KEY = VALUE: what; allowed: ...". Caught by the door, never by a caller.
struct Refusal : std::runtime_error {
  Refusal(std::string code_, const std::string& message, std::string key_, int line_ = 1)
      : std::runtime_error(message), code(std::move(code_)), key(std::move(key_)), line(line_) {}
  std::string code;  ///< a stable word, such as wrong_type
  std::string key;   ///< path, such as joint.law.stiffness[2]; empty: the whole
  int line;
};

}  // namespace halfway::reference
