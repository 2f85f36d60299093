// How an outcome reaches people and services: the options that compare and gate share.
#pragma once

#include "reports/history/gate/line.hpp"

namespace CLI {
class App;
}

namespace halfway::gate {

struct TellOptions {
  bool all = false;
  std::string markdown, service = "auto", code_quality = "gl-code-quality-report.json";
};
void add_options(CLI::App& command, TellOptions& options);

/// Refuses options that could not be followed, before the work. Throws reports::BadInput.
void check(const TellOptions& options);

/// Prints it, writes what was asked for, and throws reports::FailedRun (exit code 1) of a regression.
void tell(const Outcome& outcome, const TellOptions& options);

}  // namespace halfway::gate
