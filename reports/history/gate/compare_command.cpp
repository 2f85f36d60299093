// halfway compare: two runs that are there, exact values.
#include "reports/history/gate/commands.hpp"
#include "reports/history/gate/record.hpp"
#include "reports/history/gate/told.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::gate {
namespace {

struct CompareOptions {
  std::string before, after;
  TellOptions tell;
};

void run(const CompareOptions& options) {
  check(options.tell);
  tell(compare(read_report(options.before), read_report(options.after)), options.tell);
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "What got worse between two reports: exit code 1");
  command->add_option("before", options->before, "Folder of a report, or its results.json")->required();
  command->add_option("after", options->after, "The same of the later one")->required();
  add_options(*command, options->tell);
  command->callback([options] { run(*options); });
}

}  // namespace halfway::gate
