// halfway-gate: compare and gate, without the history.
#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/history/gate/commands.hpp"

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

int run(int argc, char** argv) {
  CLI::App app{"Did it get worse?", "halfway"};
  app.require_subcommand(1);
  app.footer("Exit codes: 0 nothing got worse; 1 something did, or the run failed; 2 the input is wrong.");
  gate::add_compare(app);
  gate::add_gate(app);
  try {
    app.parse(argc, argv);
    return 0;
  } catch (const CLI::Success& e) {
    std::ostringstream text;
    app.exit(e, text, text);
    reports::print(text.str());
    return 0;
  } catch (const CLI::ParseError& e) {
    return complain(2, std::string(e.what()) + "; see halfway gate --help");
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
