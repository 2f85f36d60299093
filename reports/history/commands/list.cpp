// halfway history list: the runs.
#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>

namespace halfway::history {
namespace {

using reports::print, reports::printable;

void list(const std::string& file) {
  const History h = load(file);
  std::vector<int> times(h.runs.size()), changes(h.runs.size());
  for (const auto& of_figure : h.times)
    for (const TimeAt& t : of_figure) ++times[t.run];
  for (const auto& of_figure : h.changes)
    for (const ReadingAt& c : of_figure) ++changes[c.run];
  for (std::size_t i = 0; i < h.series.size(); ++i) {
    const Series& s = h.series[i];
    print(printable(fmt::format("series {}: {}, {} cores, {}; {}; {} {}", i + 1, s.machine.cpu,
                                s.machine.cores, s.isa, s.compiler, s.build_type, s.flags)) +
          "\n");
  }
  print(fmt::format("{:>5}  {:<20}  {:<13} {:>6} {:>6} {:>8} {:>6}  {}\n", "run", "date", "commit", "series",
                    "times", "changes", "load", "title"));
  for (std::size_t i = 0; i < h.runs.size(); ++i) {
    const Run& r = h.runs[i];
    const std::string release = r.release.empty() ? "" : "[" + r.release + "] ";
    print(fmt::format("{:>5}  {:<20}  {:<13} {:>6} {:>6} {:>8} {:>6}  {}\n", r.id, r.date,
                      printable(r.commit.substr(0, 12)) + (r.dirty ? "+" : ""), r.series + 1, times[i],
                      changes[i], std::isnan(r.load) ? "" : fmt::format("{:.2f}", r.load),
                      printable(release + r.title)));
  }
}

}  // namespace

void add_list(CLI::App& history) {
  const auto file = std::make_shared<std::string>(kFile);
  CLI::App* command = history.add_subcommand("list", "The runs, by date");
  add_file(*command, *file);
  command->callback([file] { list(*file); });
}

}  // namespace halfway::history
