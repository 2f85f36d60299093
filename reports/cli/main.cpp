// halfway and halfway-suite: the command line.
#include "reference/scene/joint/names.hpp"
#include "reference/scene/scene.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/program.hpp"

int main(int argc, char** argv) {
  using namespace halfway;
  const auto unknown = [](std::string_view what, std::string_view name,
                          const std::vector<std::string_view>& allowed) {
    return reference::unknown_name(what, name, allowed);
  };
  const auto is_bad_input = [](const std::exception& e) {
    return dynamic_cast<const reference::SceneError*>(&e) != nullptr;
  };
  return reports::run_program(
      {"Halfway verifies and times deformable joints at finite rotations.",
       "Exit codes: 0 done; 1 the run failed, or something could not be written; 2 the input is wrong.",
       reports::add_commands, unknown, is_bad_input},
      argc, argv);
}
