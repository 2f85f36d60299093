// The commands: one file each, one function each that registers it.
#pragma once

#include "reports/cli/errors.hpp"

#include <string>

namespace CLI {
class App;
}

namespace halfway::reference {
struct ChainScene;
}

namespace halfway::reports {

/// Those of this program: reports/cli/commands.cpp of `halfway`, reports/suite/commands.cpp of
/// `halfway-suite`.
void add_commands(CLI::App& app);

/// Can results be written there? Asked before the work. Throws BadInput.
void try_output(const std::string& folder);

struct RunOptions;
/// Solves a chain, which takes the batches of every formulation: of the programs that are built with them.
using RunChain = void (*)(const RunOptions&, const reference::ChainScene&);
/// @param run_chain  nullptr: scenes of chains are refused by name
void add_run(CLI::App& app, RunChain run_chain = nullptr);

void add_list(CLI::App& app);
void add_eval(CLI::App& app);
void add_bench(CLI::App& app);
void add_report(CLI::App& app);
void add_reference(CLI::App& app);

}  // namespace halfway::reports
