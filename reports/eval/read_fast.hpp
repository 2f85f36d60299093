// Lines as they should be, at the speed of simdjson.
#pragma once

#include "reports/eval/line_tree.hpp"

namespace halfway::reports {

/// Builds the tree. Its texts are good until the thread reads its next line.
/// @return  is the line a JSON object within the bounds? If not, what is in the document means nothing.
bool read_fast(std::string_view line, reference::Document& document);

}  // namespace halfway::reports
