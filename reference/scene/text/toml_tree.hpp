// A TOML file as a plain tree with line numbers; the only door to toml++, which is heavy to compile.
#pragma once

#include "reference/scene/text/document.hpp"

#include <filesystem>

namespace halfway::reference {

/// Parses a file of at most 1 MB into `out`, which is empty. Throws SceneError when it cannot be read or is
/// not TOML, Refusal [too_deep] when it is nested deeper than kDeepestNesting.
void read_toml(const std::filesystem::path& file, Document& out);

/// The same of a text that no file holds yet; `name` stands for it in messages.
void read_toml_text(const std::string& text, const std::string& name, Document& out);

}  // namespace halfway::reference
