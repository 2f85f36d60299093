// halfway bench: the benchmarks as a table.
#include "bench/harness/timing.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/speed.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>
#include <regex>

namespace halfway::reports {
namespace {

/// How many times faster than the readable transcription of the same joint, empty where there is none.
std::string gain(const bench::Run& run, const bench::Timing& t) {
  if (t.implementation == "reference" || t.formulation.empty()) return "";
  for (const auto& r : run.timings) {
    if (r.implementation == "reference" && r.method.empty() && r.formulation == t.formulation &&
        r.kind == t.kind && r.what == t.what && !r.wrong)
      return fmt::format("{:.1f}x", r.ns / t.ns);
  }
  return "";
}

/// Share of the measured peak of the instruction set that the code is made for.
std::string share(const bench::Peaks& peaks, const bench::Timing& t) {
  if (!(t.flops > 0)) return "";
  const std::string isa = t.isa.empty() ? "scalar" : t.isa;
  for (const auto& p : peaks)
    if (p.isa == isa && p.precision == t.precision)
      return fmt::format("{:.0f}%", 100 * t.flops / t.ns / p.flops_per_ns);
  return "";
}

std::string of_ports(const bench::Peaks& peaks, const bench::Timing& t) {
  for (const auto& p : peaks)
    if (p.isa == t.isa && p.precision == t.precision && t.products > 0)
      return fmt::format("{:.0f}%", 100 * bench::share_of_ports(t, p));
  return "";
}

void print_table(const bench::Run& run) {
  print(fmt::format("{}; {}; {}; commit {}\n", run.context.machine, run.context.compiler, run.context.flags,
                    run.context.commit));
  print(fmt::format("{:<58} {:>10} {:>7} {:>11} {:>9} {:>8} {:>8} {:>8}\n", "benchmark", "ns (CPU)", "spread",
                    "worst error", "flops", "of peak", "of ports", "gain"));
  for (const auto& t : run.timings) {
    if (t.wrong)
      print(fmt::format("{:<58} not timed: {}\n", t.name, t.message));
    else
      print(fmt::format("{:<58} {:>10.1f} {:>6.1f}% {:>11.2g} {:>9} {:>8} {:>8} {:>8}\n", t.name, t.ns,
                        100 * t.spread, t.error, t.flops > 0 ? fmt::format("{:.0f}", t.flops) : "",
                        share(run.peaks, t), of_ports(run.peaks, t), gain(run, t)));
  }
}

void print_targets(const bench::Run& run) {
  print(fmt::format("\n{:<84} {:>8} {:>10}\n", "target (ratios within this run)", "value", "limit"));
  for (const Target& t : speed_targets(run)) {
    const std::string limit = fmt::format("{} {:.2f}", t.at_least ? ">=" : "<=", t.limit);
    if (std::isnan(t.value))
      print(fmt::format("{:<84} {:>8} {:>10}  {}\n", t.name, "-", limit,
                        t.note.empty() ? "not timed" : t.note));
    else
      print(fmt::format("{:<84} {:>8.2f} {:>10}  {}\n", t.name, t.value, limit, t.met() ? "met" : t.note));
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
  print_targets(run);
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
