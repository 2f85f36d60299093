// JSON with comments and YAML as the plain tree that scenes and requests are, each value with its line.
#pragma once

#include "reference/scene/text/document.hpp"

#include <string_view>

namespace halfway::imports {

reference::Document read_json(std::string_view text);
/// The first document; anchors are refused. Says which package is missing where it was built without
/// yaml-cpp.
reference::Document read_yaml(std::string_view text);

}  // namespace halfway::imports
