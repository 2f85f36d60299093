// The commands of halfway-advise.
#pragma once

namespace CLI {
class App;
}

namespace halfway::advise {

void add_advise(CLI::App& app);

}  // namespace halfway::advise
