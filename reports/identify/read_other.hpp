// Data that are no text of columns: curves of a bushing's property file, results of our own finite elements.
#pragma once

#include "reports/identify/read_csv.hpp"

namespace halfway::reports {

/// By what stands in it: a .bus (TeimOrbit), JSON of reference/data/fe, else columns.
/// @param law  of a result of several material laws this one; "" where there is one
ReadCurves read_data_file(std::string_view text, const std::string& law);

/// Six curves, each of one component with the others held.
ReadCurves read_bus(std::string_view text);

/// Curves of a solid under a load, or its compliance and couplings, of which moments in pairs are made, both
/// ways.
ReadCurves read_fe(std::string_view text, const std::string& law);

}  // namespace halfway::reports
