// halfway identify.
#pragma once

namespace CLI {
class App;
}

namespace halfway::reports {

void add_identify(CLI::App& app);

}  // namespace halfway::reports
