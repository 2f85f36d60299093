// The commands that need joints and scenes alone: `halfway`, built in a minute.
#include "reports/cli/commands.hpp"

namespace halfway::reports {

void add_commands(CLI::App& app) {
  add_list(app);
  add_run(app);
  add_eval(app);
}

}  // namespace halfway::reports
