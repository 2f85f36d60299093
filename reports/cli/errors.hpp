// What a command throws, and the exit code that it becomes.
#pragma once

#include <stdexcept>

namespace halfway::reports {

/// What the caller got wrong: exit code 2.
struct BadInput : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The work was understood and failed: exit code 1.
struct FailedRun : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace halfway::reports
