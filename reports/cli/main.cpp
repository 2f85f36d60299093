// halfway: the command line. Exit codes: 0 done, 1 the run failed, 2 the input is wrong.
#include "reference/scene/scene.hpp"
#include "reports/cli/commands.hpp"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

namespace {

int complain(int code, std::string message) {
  for (char& c : message) {
    if (c == '\n') c = ' ';  // one message, one line
  }
  fmt::print(stderr, "halfway: {}\n", message);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace halfway;
  CLI::App app{"Halfway verifies and times deformable joints at finite rotations.", "halfway"};
  app.require_subcommand(1);
  reports::add_commands(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& e) {  // --help
    return app.exit(e);
  } catch (const CLI::ParseError& e) {
    return complain(2, std::string(e.what()) + "; see halfway --help");
  } catch (const reports::BadInput& e) {
    return complain(2, e.what());
  } catch (const reference::SceneError& e) {
    return complain(2, e.what());
  } catch (const std::exception& e) {
    return complain(1, e.what());
  }
}
