// What holds whatever text is given to an advice as its truth.
#pragma once

#include <string>
#include <string_view>

namespace halfway::advise::test {

/// Empty, or the promise that is broken: a refusal is one short line that names the file and, but for a file
/// without rows, a line of it; what is read has load factors that ascend from above zero, each with a finite
/// value for every output.
std::string broken_table_promise(std::string_view text);

}  // namespace halfway::advise::test
