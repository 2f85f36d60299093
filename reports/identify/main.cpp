// halfway-identify: `halfway identify`.
#include "reference/scene/scene.hpp"
#include "reports/cli/program.hpp"
#include "reports/identify/command.hpp"

int main(int argc, char** argv) {
  using namespace halfway;
  const auto is_bad_input = [](const std::exception& e) {
    return dynamic_cast<const reference::SceneError*>(&e) != nullptr;
  };
  return reports::run_program(
      {"A joint from measured curves.",
       "Exit codes: 0 done; 1 the run failed, or something could not be written; 2 the input is wrong.",
       reports::add_identify, nullptr, is_bad_input},
      argc, argv);
}
