// halfway bench: the benchmarks as a table.
#include "bench/timing.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/progress.hpp"

#include <fmt/format.h>

#include <memory>
#include <regex>

namespace halfway::reports {
namespace {

void print_table(const bench::Run& run) {
  fmt::print("{}; {}; {}; commit {}\n", run.context.machine, run.context.compiler, run.context.flags,
             run.context.commit);
  fmt::print("{:<50} {:>12} {:>8} {:>12}\n", "benchmark", "ns (CPU)", "spread", "worst error");
  for (const auto& t : run.timings) {
    if (t.wrong)
      fmt::print("{:<50} not timed: {}\n", t.name, t.message);
    else
      fmt::print("{:<50} {:>12.1f} {:>7.1f}% {:>12.2g}\n", t.name, t.ns, 100 * t.spread, t.error);
  }
}

void run_bench(const bench::Options& options) {
  try {
    const std::regex check(options.filter);
  } catch (const std::regex_error&) {
    throw BadInput(fmt::format("--filter: '{}' is not a regular expression", options.filter));
  }
  const bench::Run run = bench::run(options, Progress("timing"));
  if (run.timings.empty()) throw BadInput(fmt::format("--filter: no benchmark matches '{}'", options.filter));
  print_table(run);
  for (const auto& t : run.timings) {
    if (t.wrong) throw FailedRun(t.name + " is wrong and was not timed: " + t.message);
  }
}

}  // namespace

void add_bench(CLI::App& app) {
  const auto options = std::make_shared<bench::Options>();
  CLI::App* command = app.add_subcommand("bench", "Time every formulation, each checked before it is timed");
  command->add_option("--filter", options->filter, "Regular expression over names")->capture_default_str();
  command->add_option("--repetitions", options->repetitions, "Repetitions of each")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  command->add_option("--min-time", options->min_time, "Seconds per repetition")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--json", options->json_file, "Google Benchmark's own JSON goes to this file");
  command->callback([options] { run_bench(*options); });
}

}  // namespace halfway::reports
