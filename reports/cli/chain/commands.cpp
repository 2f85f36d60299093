// What runs chains: `halfway-chains`.
#include "reports/cli/commands.hpp"
#include "reports/cli/run/run_options.hpp"

namespace halfway::reports {

void add_commands(CLI::App& app) { add_run(app, run_chain); }

}  // namespace halfway::reports
