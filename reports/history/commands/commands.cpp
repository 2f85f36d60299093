// The commands of halfway-history, each a line.
#include "reports/history/commands/commands.hpp"

namespace halfway::history {

void add_commands(CLI::App& app) {
  add_history(app);
  add_dashboard(app);
}

}  // namespace halfway::history
