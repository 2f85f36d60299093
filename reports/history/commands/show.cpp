// halfway history show: one run.
#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <cmath>
#include <memory>

namespace halfway::history {
namespace {

using reports::print, reports::printable;

struct ShowOptions {
  std::string run, figure, file = kFile;
};

void print_head(const Record& record) {
  const Run& r = record.run;
  const Series& s = record.series;
  const Machine& m = s.machine;
  print(printable(
            fmt::format("run {}: commit {}{}, {}", r.id, r.commit, r.dirty ? " with changes" : "", r.date)) +
        "\n");
  const std::pair<const char*, std::string> rows[] = {
      {"title", r.title},
      {"release", r.release},
      {"machine", fmt::format("{}, {} cores", m.cpu, m.cores)},
      {"caches", m.caches},
      {"microcode", m.microcode},
      {"load", std::isnan(r.load) ? "" : fmt::format("{:.2f}", r.load)},
      {"isa", s.isa},
      {"compiler", s.compiler},
      {"flags", s.build_type + " " + s.flags},
      {"libraries", r.libraries}};
  for (const auto& [name, text] : rows)
    if (!text.empty()) print(fmt::format("  {:<10} {}\n", name, printable(text)));
}

std::string time_text(const Time& t) {
  const std::string spread = t.low > 0 ? fmt::format(" ({:+.1f} % {:+.1f} %, {} repetitions)",
                                                     0.1 * (t.low - 1000), 0.1 * (t.high - 1000), t.n)
                                       : "";
  return fmt::format("{:.4g} ns{}", t.ns(), spread);
}

std::string exact_text(const Record::Exact& e) {
  const Reading& r = e.reading;
  const double limit = limit_of(r);
  const std::string value =
      std::isnan(r.value) ? "not measured" : fmt::format("{} {}", r.value, e.figure.unit);
  return value + (std::isnan(limit) ? "" : fmt::format(", limit {}", limit)) +
         (r.verdict == Verdict::none ? "" : fmt::format(", {}", to_string(r.verdict)));
}

void show(const ShowOptions& options) {
  const auto is_wanted = matcher(options.figure);
  const History history = load(options.file);
  const Record record = record_at(history, chosen_run(history, options.run));
  print_head(record);
  int verdicts[6] = {}, shown = 0;
  for (const auto& [name, timed] : record.timed) {
    if (options.figure.empty() || !is_wanted(name)) continue;
    print(fmt::format("  {}: {}\n", printable(name), time_text(timed.time)));
    ++shown;
  }
  for (const auto& [name, exact] : record.exact) {
    ++verdicts[int(exact.reading.verdict)];
    if (options.figure.empty() ? exact.reading.verdict != Verdict::fail : !is_wanted(name)) continue;
    print(fmt::format("  {}: {}\n", printable(name), printable(exact_text(exact))));
    ++shown;
  }
  print(fmt::format("{} times; {} other figures: {} pass, {} known failures, {} fail, {} left out\n",
                    record.timed.size(), record.exact.size(), verdicts[int(Verdict::pass)],
                    verdicts[int(Verdict::known_failure)], verdicts[int(Verdict::fail)],
                    verdicts[int(Verdict::left_out)]));
  if (!options.figure.empty() && shown == 0)
    throw reports::BadInput(fmt::format("--figure: no figure of this run matches '{}'", options.figure));
}

}  // namespace

void add_show(CLI::App& history) {
  const auto options = std::make_shared<ShowOptions>();
  CLI::App* command =
      history.add_subcommand("show", "One run: its circumstances, what fails, and figures by name");
  command->add_option("run", options->run,
                      "Number of a run, or the beginning of a commit; default: the last run");
  command->add_option("--figure", options->figure, "Regular expression: figures to show; . shows all");
  add_file(*command, options->file);
  command->callback([options] { show(*options); });
}

}  // namespace halfway::history
