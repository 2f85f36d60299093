// halfway-history: what is kept, compared and drawn over time.
#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace {

using namespace halfway;

int complain(int code, std::string message) {
  std::ranges::replace(message, '\n', ' ');  // one message, one line
  reports::tell(fmt::format("halfway: {}\n", reports::printable(message)));
  return code;
}

/// CLI11 says "A subcommand is required" of an unknown one.
void check_command(const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || *argv[1] == '-') return;
  std::string names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return check_command(*command, argc - 1, argv + 1);
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  if (!names.empty())
    throw reports::BadInput(fmt::format("unknown command '{}'; allowed: {}", argv[1], names));
}

int run(int argc, char** argv) {
  CLI::App app{"What the figures came to, over time.", "halfway"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "halfway " HALFWAY_VERSION);
  app.footer(
      "Exit codes: 0 done; 1 the run failed, or something could not be written; 2 the input is wrong.");
  history::add_commands(app);
  try {
    check_command(app, argc, argv);
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& e) {  // --help, --version
    std::ostringstream text;
    app.exit(e, text, text);
    reports::print(text.str());
    return 0;
  } catch (const CLI::ParseError& e) {
    return complain(2, std::string(e.what()) + "; see --help");
  } catch (const reports::BadInput& e) {
    return complain(2, e.what());
  } catch (const std::exception& e) {
    return complain(1, e.what());
  }
}

}  // namespace

int main(int argc, char** argv) {
  reports::reserve_streams();
  const int code = run(argc, argv);
  if (!reports::lost_output() || code != 0) return code;
  return complain(1, "standard output or error could not be written: something is missing there");
}
