// halfway compare: two runs that are there, exact values.
#include "reports/history/gate/commands.hpp"
#include "reports/history/gate/named.hpp"
#include "reports/history/gate/told.hpp"

#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::gate {
namespace {

struct CompareOptions {
  std::string before, after;
  bool newest = false;
  TellOptions tell;
};

void run(const CompareOptions& options) {
  check(options.tell);
  const auto [before, after] = read_both(options.before, options.after, options.newest);
  tell(compare(before, after), options.tell);
}

}  // namespace

void add_compare(CLI::App& app) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* command = app.add_subcommand("compare", "What got worse between two runs: exit code 1");
  command
      ->add_option("before", options->before,
                   "Folder of a report, its results.json, or FILE@RUN: a history, exported (.jsonl) or not "
                   "(.sqlite), and the number or commit of a run; without @RUN its last run made like AFTER")
      ->required();
  command->add_option("after", options->after, "The same of the later one")->required();
  command->add_flag(
      "--newest", options->newest,
      "Of a history without @RUN the runs of its last commit alone: what was accepted with it is not "
      "judged again where only an older run was made like AFTER");
  add_options(*command, options->tell);
  command->callback([options] { run(*options); });
}

}  // namespace halfway::gate
