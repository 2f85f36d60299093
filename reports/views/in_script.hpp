// JSON inside a page.
#pragma once

#include <string>
#include <string_view>

namespace halfway::reports {

/// JSON that can stand inside an HTML script element: no "</script" and no "<!--" can occur, because "<" is
/// only legal inside JSON strings, where the escape means the same.
std::string in_script(std::string_view json);

}  // namespace halfway::reports
