// A TOML file as a plain tree with line numbers; the only door to toml++, which is heavy to compile.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace halfway::reference {

struct TomlNode {
  enum class Type { table, array, text, number, boolean, date };
  Type type = Type::table;
  int line = 1;
  std::string shown;        ///< the value as found, shortened, for messages
  std::string text;         ///< of a text
  double number = 0;        ///< of a number, integers included
  bool is_integer = false;  ///< a number written as integer
  bool boolean = false;
  std::vector<std::string> keys;  ///< of a table, in the order of the file; one for each item
  std::vector<TomlNode> items;    ///< of a table or array
};

/// Parses a file of at most 1 MB. Throws SceneError when it cannot be read or is not TOML.
TomlNode read_toml(const std::filesystem::path& file);

}  // namespace halfway::reference
