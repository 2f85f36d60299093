// A scene file or a request as one plain tree, and what is wrong with a value of it: TOML and JSON are
// read by the same words and rules; the doors differ in how a refusal is printed.
#pragma once

#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

/// Tables and arrays inside each other, of either door: a joint needs five.
inline constexpr int kDeepestNesting = 32;

/// One value of a document; what it holds follows it.
struct DocumentNode {
  enum class Type : unsigned char { table, array, text, number, boolean, date, nothing };
  Type type = Type::table;
  bool is_integer = false;  ///< a number of TOML written as integer
  bool boolean = false;
  int line = 1;
  unsigned end = 0;  ///< node after the last one that it holds; 0: still being read
  double number = 0;
  std::string_view text{};  ///< of a text; of a number or date as it was written
  std::string_view key{};   ///< in the table that holds it
};

/// "a table", "a number" ...
const char* type_name(DocumentNode::Type type);

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

/// What a reader asked of one value: of such questions the format's schema is made (reports/cli/schema).
struct Question {
  enum class Type { keys, required_key, text, boolean, number, integer, name, names, numbers, matrix };
  std::size_t place;  ///< of the value
  Type type;
  std::vector<std::string> words{};  ///< keys or names that are allowed
  double low = 0, high = 0;          ///< of an integer
  std::string unit{};                ///< that texts may have, in SI
  int size = 0;                      ///< of an array; 0: any
};

/// The tree in the order of the text: no node has memory of its own, so that long requests are read at the
/// speed of their numbers. Texts are the door's, or kept here: a copy would see those of the first, and there
/// is none.
struct Document {
  std::vector<DocumentNode> nodes{};  ///< the root, and everything in it
  Dialect dialect = kScene;
  std::vector<std::string> notes{};  ///< "KEY what was accepted and changed": the first of them
  std::size_t more_notes = 0;        ///< than those
  std::vector<std::unique_ptr<const std::string>> texts{};  ///< those that stand nowhere as they are
  std::vector<Question>* questions = nullptr;               ///< where what is asked is kept, if anywhere

  /// The next value of what is open; it holds nothing, or not yet. Good until the next one.
  DocumentNode& add(DocumentNode::Type type, std::string_view key) {
    const bool holds = type == DocumentNode::Type::table || type == DocumentNode::Type::array;
    DocumentNode& node = nodes.emplace_back();
    node.type = type;
    node.end = holds ? 0 : unsigned(nodes.size());
    node.key = key;
    return node;
  }
  /// Nothing more comes into it, the innermost that is open.
  void close(std::size_t place) { nodes[place].end = unsigned(nodes.size()); }
  std::string_view keep(std::string text) {
    return *texts.emplace_back(std::make_unique<const std::string>(std::move(text)));
  }
};

/// The nodes from the root, left out, to a place: each in the one before it.
std::vector<std::size_t> way_to(const Document& document, std::size_t place);

/// Key path of a node, such as law.K[2]: from the root on, which has none. Long keys are cut.
std::string path_of(const Document& document, std::size_t place);

/// The value as a person would type it, shortened.
std::string shown(const Document& document, std::size_t place);

/// A mistake in a scene file: "FILE:LINE: KEY = VALUE: what is wrong; allowed: ...".
struct SceneError : std::runtime_error {
  using std::runtime_error::runtime_error;
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
