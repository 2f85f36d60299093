// halfway-gate: compare and gate, without the history.
#include "reports/cli/program.hpp"
#include "reports/history/gate/commands.hpp"

int main(int argc, char** argv) {
  const auto add_commands = [](CLI::App& app) {
    halfway::gate::add_compare(app);
    halfway::gate::add_gate(app);
  };
  return halfway::reports::run_program(
      {"Did it get worse?",
       "Exit codes: 0 nothing got worse; 1 something did, or the run failed; 2 the input is wrong.",
       add_commands},
      argc, argv);
}
