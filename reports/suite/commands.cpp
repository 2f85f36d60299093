// Every command: `halfway-suite`.
#include "reports/cli/commands.hpp"
#include "reference/face/registry.hpp"
#include "reports/cli/run/run_options.hpp"

namespace halfway::reports {

void add_commands(CLI::App& app) {
  reference::complete_catalog();
  add_list(app);
  add_run(app, run_chain);
  add_eval(app);
  add_bench(app);
  add_report(app);
  add_reference(app);
}

}  // namespace halfway::reports
