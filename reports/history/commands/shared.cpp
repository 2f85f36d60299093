#include "reports/history/commands/commands.hpp"
#include "reports/history/exchange/lines.hpp"
#include "reports/history/store/store.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <regex>

namespace halfway::history {

void add_history(CLI::App& app) {
  CLI::App* command = app.add_subcommand("history", "Reports, kept: what each figure came to at each run");
  command->require_subcommand(1);
  add_add(*command);
  add_list(*command);
  add_show(*command);
  add_prune(*command);
  add_export(*command);
  add_import(*command);
}

void add_file(CLI::App& command, std::string& file) {
  command.add_option("--file", file, "The history")->capture_default_str();
}

History load(const std::string& file) {
  if (is_lines(file)) return read_history(file);
  History out;
  with_store(file, Access::read, [&](Store& store) { out = store.load(); });
  return out;
}

int chosen_run(const History& history, const std::string& text) {
  const int run = find_run(history, text);
  if (run >= 0) return run;
  if (history.runs.empty())
    throw reports::BadInput("the history has no run yet; ./halfway history add keeps one");
  throw reports::BadInput(
      fmt::format("no run '{}': neither a number nor the beginning of a commit that "
                  "./halfway history list names",
                  text));
}

std::function<bool(const std::string&)> matcher(const std::string& pattern) {
  if (pattern.empty()) return [](const std::string&) { return true; };
  try {
    return [expression = std::regex(pattern)](const std::string& name) {
      return std::regex_search(name, expression);
    };
  } catch (const std::regex_error&) {
    throw reports::BadInput(fmt::format("--figure: '{}' is not a regular expression", pattern));
  }
}

}  // namespace halfway::history
