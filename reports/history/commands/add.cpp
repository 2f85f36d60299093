// halfway history add: a report becomes a run.
#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"
#include "reports/history/intake/intake.hpp"
#include "reports/history/store/store.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>
#include <stdexcept>

namespace halfway::history {
namespace {

struct AddOptions {
  std::string folder = "out/report", file = kFile, title, release, date;
};

/// Refused before the report is read.
void check_date(const std::string& date) {
  try {
    if (!date.empty()) seconds_of(date);
  } catch (const std::invalid_argument& error) {
    throw reports::BadInput(fmt::format("--{}", error.what()));
  }
}

void add(const AddOptions& options) {
  check_date(options.date);
  Added added = read_report(options.folder);
  Run& run = added.record.run;
  run.title = options.title.empty() ? subject_of(run.commit) : options.title;
  run.release = options.release;
  if (!options.date.empty()) run.date = options.date;
  with_store(options.file, Access::write, [&](Store& store) {
    const auto [id, was_there] = store.add(added.record);
    reports::print(fmt::format("run {} {} {}{}, {}: {} times, {} other figures\n", id,
                               was_there ? "is already" : "is", reports::printable(run.commit),
                               run.dirty ? " with changes" : "", run.date, added.record.timed.size(),
                               added.record.exact.size()));
  });
  if (!added.note.empty()) reports::tell(fmt::format("note: {}\n", added.note));
}

}  // namespace

void add_add(CLI::App& history) {
  const auto options = std::make_shared<AddOptions>();
  CLI::App* command = history.add_subcommand("add", "Keep a report");
  command->add_option("report", options->folder, "Folder of the report")->capture_default_str();
  add_file(*command, options->file);
  command->add_option("--title", options->title,
                      "What the run is called; default: the subject of its commit");
  command->add_option("--release", options->release, "Name of the release that this commit is");
  command->add_option(
      "--date", options->date,
      "Its place among the runs, UTC; default: when the report was made. For a commit that is "
      "measured later: the date of the commit");
  command->callback([options] { add(*options); });
}

}  // namespace halfway::history
