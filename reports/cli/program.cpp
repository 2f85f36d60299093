#include "reports/cli/program.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <sstream>

namespace halfway::reports {
namespace {

int complain(int code, std::string message) {
  std::ranges::replace(message, '\n', ' ');  // one message, one line
  tell(fmt::format("halfway: {}\n", printable(message)));
  return code;
}

/// CLI11 says "A subcommand is required" of an unknown one.
void check_command(const Program& program, const CLI::App& app, int argc, char** argv) {
  if (argc < 2 || *argv[1] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (command->get_name() == argv[1]) return check_command(program, *command, argc - 1, argv + 1);
    names.push_back(command->get_name());
  }
  if (names.empty()) return;
  const std::vector<std::string_view> allowed(names.begin(), names.end());
  throw BadInput(program.unknown
                     ? program.unknown("command", argv[1], allowed)
                     : fmt::format("unknown command '{}'; allowed: {}", argv[1], fmt::join(names, ", ")));
}

int run(const Program& program, int argc, char** argv) {
  CLI::App app{program.title, "halfway"};
  app.require_subcommand(1);
  app.set_version_flag("--version", "halfway " HALFWAY_VERSION);
  app.footer(program.exit_codes);
  program.add_commands(app);
  try {
    check_command(program, app, argc, argv);
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& e) {  // --help, --version
    std::ostringstream text;
    app.exit(e, text, text);
    print(text.str());
    return 0;
  } catch (const CLI::ParseError& e) {
    return complain(2, std::string(e.what()) + "; see halfway --help");
  } catch (const BadInput& e) {
    return complain(2, e.what());
  } catch (const std::exception& e) {
    return complain(program.is_bad_input && program.is_bad_input(e) ? 2 : 1, e.what());
  }
}

}  // namespace

int run_program(const Program& program, int argc, char** argv) {
  reserve_streams();
  const int code = run(program, argc, argv);
  if (!lost_output() || code != 0) return code;
  return complain(1, "standard output or error could not be written: something is missing there");
}

}  // namespace halfway::reports
