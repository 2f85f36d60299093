// halfway gate: two commits, timed in turn on this machine.
#include "reports/cli/errors.hpp"
#include "reports/cli/interrupts.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/streams.hpp"
#include "reports/history/gate/commands.hpp"
#include "reports/history/gate/judge.hpp"
#include "reports/history/gate/process.hpp"
#include "reports/history/gate/self.hpp"
#include "reports/history/gate/side_report.hpp"
#include "reports/history/gate/sides.hpp"
#include "reports/history/gate/told.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <memory>
#include <regex>

namespace halfway::gate {
namespace {

namespace fs = std::filesystem;

struct GateOptions {
  std::string base, head;
  Places places{HALFWAY_SOURCE, "out/gate", 3};
  BenchOptions bench{.filter = filter_of(fast_figures())};
  TimeRules rules{};
  std::string spread = HALFWAY_SPREAD;
  bool again = false, report = false;
  int self = 0, slowed = 0;
  std::vector<double> slower = SelfPlan{}.slower;
  TellOptions tell;
};

/// What makes measurements those of one comparison: the programs to the byte and second, and the options.
nlohmann::json about(const GateOptions& o, const std::vector<fs::path>& base,
                     const std::vector<fs::path>& head) {
  nlohmann::json out{{"schema", "halfway-gate-journal"}, {"version", 1},       {"filter", o.bench.filter},
                     {"min_time", o.bench.min_time},     {"slower", o.slower}, {"pairs", o.rules.pairs}};
  for (const auto* programs : {&base, &head}) {
    auto& side = out[programs == &base ? "base" : "head"] = nlohmann::json::array();
    for (const fs::path& p : *programs)
      side.push_back({fs::absolute(p), fs::file_size(p), fs::last_write_time(p).time_since_epoch().count()});
  }
  return out;
}

/// A name as a part of a path.
std::string plain(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-') c = '_';
  return text.substr(text.size() > 60 ? text.size() - 60 : 0);
}

Journal open_journal(const GateOptions& o, const fs::path& folder, const nlohmann::json& what) {
  const fs::path file = folder / "journal.jsonl";
  if (o.again) fs::remove(file);
  Journal journal(file, what);
  if (journal.size() > 0)
    reports::tell(
        fmt::format("{} measurements are there from before, in {}\n", journal.size(), file.string()));
  return journal;
}

void run_self(const GateOptions& o) {
  const fs::path folder = o.places.out / "self";
  SelfPlan plan{.runs = o.self, .slower = o.slower, .bench = o.bench, .rules = o.rules};
  Places places = o.places;
  places.layouts = 12;
  plan.programs = find_side(o.base, places).programs;
  plan.slowed_runs = o.slowed > 0 ? o.slowed : (o.self + 3) / 4;
  if (o.self == 0) plan.rules.allowed = read_allowed(o.spread);
  plan.command =
      fmt::format("./halfway gate{}{} --slowed {} --min-time {} --slower {}", o.base.empty() ? "" : " BASE",
                  o.self > 0 ? fmt::format(" --self {}", o.self) : "", plan.slowed_runs, o.bench.min_time,
                  fmt::join(o.slower, ","));
  fs::create_directories(folder);
  const reports::FolderLock lock(folder);
  Journal journal = open_journal(o, folder, about(o, plan.programs, {}));
  reports::Progress progress("comparisons");
  measure_self(plan, journal, folder, std::ref(progress));
  reports::print(fmt::format("wrote {}\n", (folder / result_name(plan)).string()));
}

void add(Outcome& outcome, const Outcome& more) {
  outcome.lines.insert(outcome.lines.end(), more.lines.begin(), more.lines.end());
  outcome.notes.insert(outcome.notes.end(), more.notes.begin(), more.notes.end());
  outcome.compared += more.compared;
}

void run_gate(const GateOptions& o) {
  if (o.base.empty()) throw reports::BadInput("BASE is missing: a commit, a program or a folder of a build");
  TimeRules rules = o.rules;
  if (fs::exists(o.spread)) rules.allowed = read_allowed(o.spread);
  const Side base = find_side(o.base, o.places), head = find_side(o.head, o.places);
  const fs::path folder = o.places.out / (plain(base.name) + ".." + plain(head.name));
  fs::create_directories(folder);
  const reports::FolderLock lock(folder);
  Journal journal = open_journal(o, folder, about(o, base.programs, head.programs));
  reports::Progress progress("timing");
  const Measured measured = measure_times(journal, base, head, o.bench, rules, 0, folder, std::ref(progress));
  Outcome outcome = judge(measured, base, head, rules, [&](const Side& side, const std::string& figure) {
    return instructions(side, figure, folder);
  });
  if (o.report) {
    // A commit's report stays with its builds, that of a program with this comparison.
    const auto place = [&](const Side& side, const char* name) {
      return side.commit.empty() ? folder / name : o.places.out / side.commit.substr(0, 12);
    };
    add(outcome, compare(side_report(base, place(base, "base")), side_report(head, place(head, "head"))));
  } else {
    outcome.notes.push_back(
        "accuracy of what was timed alone; --report compares every finding (minutes a side)");
  }
  if (rules.allowed.empty())
    outcome.notes.push_back("no table of what layouts alone do to each figure: 3 % is allowed to all");
  tell(outcome, o.tell);
}

void run(const GateOptions& o) {
  check(o.tell);
  try {
    const std::regex filter(o.bench.filter);
  } catch (const std::regex_error&) {
    throw reports::BadInput(fmt::format("--filter: '{}' is not a regular expression", o.bench.filter));
  }
  reports::catch_interrupts();
  o.self > 0 || o.slowed > 0 ? run_self(o) : run_gate(o);
}

}  // namespace

void add_gate(CLI::App& app) {
  const auto o = std::make_shared<GateOptions>();
  CLI::App* command =
      app.add_subcommand("gate", "What got slower between two commits, timed in turn: exit code 1");
  command->add_option("BASE", o->base, "A commit, a benchmark program, or a folder with bin/halfway_bench");
  command->add_option("HEAD", o->head, "The same; without it, this tree as it is");
  command->add_option("--filter", o->bench.filter, "Figures, a regular expression; default: a dozen");
  command->add_option("--pairs", o->rules.pairs, "Processes of each side")
      ->capture_default_str()
      ->check(CLI::Range(9, 1000));
  command
      ->add_option("--min-time", o->bench.min_time, "Seconds per repetition, of which the least of 3 counts")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  command->add_option("--spread", o->spread, "Table of what layouts alone do, of --self");
  command->add_option("--out", o->places.out, "Folder of builds and measurements")->capture_default_str();
  command
      ->add_option("--layouts", o->places.layouts, "Programs of each commit, their functions in other orders")
      ->capture_default_str()
      ->check(CLI::Range(1, 20));
  command->add_flag("--report", o->report, "Compare the reports of both as well: every finding, every count");
  command->add_flag("--again", o->again, "Measure afresh what was measured before");
  command->add_option("--self", o->self, "So many comparisons of BASE with itself")
      ->check(CLI::Range(1, 10000));
  command
      ->add_option("--slowed", o->slowed,
                   "And so many of each slow-down; default: a quarter. Without --self: those alone, limits "
                   "of --spread")
      ->check(CLI::Range(1, 10000));
  command->add_option("--slower", o->slower, "Slow-downs seeded by --self, shares")
      ->delimiter(',')
      ->check(CLI::Range(0.0, 1.0));
  add_options(*command, o->tell);
  command->callback([o] { run(*o); });
}

}  // namespace halfway::gate
