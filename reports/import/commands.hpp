// halfway import and halfway export.
#pragma once

namespace CLI {
class App;
}

namespace halfway::imports {

void add_import(CLI::App& app);
void add_export(CLI::App& app);

}  // namespace halfway::imports
