// Why a known joint fails a property, and the formula that would mend it: for whoever maintains the program.
#pragma once

#include <string_view>

namespace halfway::check {

struct Cause {
  std::string_view joint, id;  ///< of the catalog or of programs.def; of the result
  const char* why;
  const char* fix;
};

/// nullptr where we do not know.
const Cause* find_cause(std::string_view joint, std::string_view id);

}  // namespace halfway::check
