// The commands of the program: one file each, one function each that registers it.
#pragma once

#include <CLI/CLI.hpp>

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

void add_list(CLI::App& app);
void add_run(CLI::App& app);
void add_eval(CLI::App& app);
void add_bench(CLI::App& app);
void add_report(CLI::App& app);
void add_reference(CLI::App& app);

}  // namespace halfway::reports
