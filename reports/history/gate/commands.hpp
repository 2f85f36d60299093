// The commands that compare: registered beside those of the history.
#pragma once

namespace CLI {
class App;
}

namespace halfway::gate {

void add_compare(CLI::App& app);
void add_gate(CLI::App& app);

}  // namespace halfway::gate
