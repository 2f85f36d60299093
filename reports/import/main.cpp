// halfway-import: `halfway import` and `halfway export`.
#include "reference/scene/scene.hpp"
#include "reports/cli/program.hpp"
#include "reports/import/commands.hpp"

#include <CLI/CLI.hpp>

int main(int argc, char** argv) {
  using namespace halfway;
  const auto add_commands = [](CLI::App& app) {
    imports::add_import(app);
    imports::add_export(app);
  };
  const auto is_bad_input = [](const std::exception& e) {
    return dynamic_cast<const reference::SceneError*>(&e) != nullptr;
  };
  return reports::run_program(
      {"Joints from and for other programs.",
       "Exit codes: 0 done; 1 the run failed, or something could not be written; 2 the input is wrong.",
       add_commands, nullptr, is_bad_input},
      argc, argv);
}
