// What difference the law of rotation makes, for files that hold none.
#pragma once

#include "reports/import/record/imported.hpp"

#include <string>
#include <vector>

namespace halfway::imports {

/// Formulations that --as may name: those without parameters that a file could not give.
std::vector<std::string_view> candidates();

/// A table: how far the moment of each candidate is from that of `invariant`, %, where the joint is turned
/// about a skew axis by 5, 20 and 45 degrees. Empty of a joint that resists no rotation.
std::string spread_table(const ImportedJoint& joint);

}  // namespace halfway::imports
