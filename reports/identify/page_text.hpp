// The report's template and styles, written by CMake.
#pragma once

namespace halfway::reports {

const char* identify_template();  ///< with the marks of reports/page/template.html
const char* identify_style();

}  // namespace halfway::reports
