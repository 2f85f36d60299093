// The kit checked: programs whose joint and mistakes are known.
#pragma once

namespace halfway::check {

/// Prints a line each. Throws reports::FailedRun when one was not told what it is.
void self_test();

}  // namespace halfway::check
