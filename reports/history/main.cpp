// halfway-history: what is kept, compared and drawn over time.
#include "reports/cli/program.hpp"
#include "reports/history/commands/commands.hpp"

int main(int argc, char** argv) {
  return halfway::reports::run_program(
      {"What the figures came to, over time.",
       "Exit codes: 0 done; 1 the run failed, or something could not be written; 2 the input is wrong.",
       halfway::history::add_commands},
      argc, argv);
}
