// What was left out of the run because this machine has no such library.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace halfway::bench {

/// (what is left out, why), one for each optional library that CMake did not find.
std::vector<std::pair<std::string, std::string>> skipped();

}  // namespace halfway::bench
