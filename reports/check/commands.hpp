// The subcommands of halfway-check.
#pragma once

namespace CLI {
class App;
}

namespace halfway::check {

void add_check(CLI::App& app);
void add_subject(CLI::App& app);

}  // namespace halfway::check
