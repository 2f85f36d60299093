// The commands of the history: one file each, one function each that registers it.
#pragma once

#include "reports/cli/errors.hpp"
#include "reports/history/record/history.hpp"

#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace halfway::history {

/// All of this program.
void add_commands(CLI::App& app);

void add_history(CLI::App& app);
void add_dashboard(CLI::App& app);

// Of `history`.
void add_add(CLI::App& history);
void add_list(CLI::App& history);
void add_show(CLI::App& history);
void add_prune(CLI::App& history);
void add_export(CLI::App& history);
void add_import(CLI::App& history);

inline constexpr const char* kFile = "out/history.sqlite";
void add_file(CLI::App& command, std::string& file);

/// The whole file, verified. Throws reports::BadInput.
History load(const std::string& file);

/// Position of the run that was asked for; "" is the last. Throws reports::BadInput.
int chosen_run(const History& history, const std::string& text);

/// Does a name match? Empty: all do. Throws reports::BadInput of what is no regular expression.
std::function<bool(const std::string&)> matcher(const std::string& pattern);

}  // namespace halfway::history
