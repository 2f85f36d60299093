// halfway-check: the conformance kit, a program of its own, so that the first answer waits for none of it.
#include "reports/check/commands.hpp"
#include "reports/cli/program.hpp"

int main(int argc, char** argv) {
  const auto add_commands = [](CLI::App& app) {
    halfway::check::add_check(app);
    halfway::check::add_subject(app);
  };
  return halfway::reports::run_program(
      {"What joint is it?", "Exit codes: 0 nothing failed; 1 something did; 2 the input is wrong.",
       add_commands},
      argc, argv);
}
