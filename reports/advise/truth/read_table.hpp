// A table of load factors and outputs as text.
#pragma once

#include "reports/advise/model/answers.hpp"

#include <string>
#include <vector>

namespace halfway::advise {

/// Lines of comma-separated values: a head with `factor` and some of `outputs`, then rows of ascending load
/// factors; lines of # and rows at rest are passed over.
/// @param name  of the file, for messages. Throws reports::BadInput, naming the line.
Answers read_table(const std::string& file_text, const std::vector<std::string>& outputs,
                   const std::string& name);

}  // namespace halfway::advise
