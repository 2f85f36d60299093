// The report of a side, for what is exact: every finding, every count.
#pragma once

#include "reports/history/gate/record.hpp"
#include "reports/history/gate/times.hpp"

namespace halfway::gate {

/// Runs the halfway-suite beside the side's programs, or builds it in their build folder first: minutes. What
/// a commit's report says does not change and is kept below `folder`. Throws reports::FailedRun where there
/// is none.
Record side_report(const Side& side, const std::filesystem::path& folder);

}  // namespace halfway::gate
