// What advises: `halfway-advise`.
#include "reports/cli/commands.hpp"

#include "reports/advise/command.hpp"

namespace halfway::reports {

void add_commands(CLI::App& app) { advise::add_advise(app); }

}  // namespace halfway::reports
