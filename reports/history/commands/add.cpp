// halfway history add: a report becomes a run.
#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"
#include "reports/history/intake/intake.hpp"
#include "reports/history/store/store.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::history {
namespace {

struct AddOptions {
  std::string folder = "out/report", file = kFile, title, release;
};

void add(const AddOptions& options) {
  Added added = read_report(options.folder);
  Run& run = added.record.run;
  run.title = options.title.empty() ? subject_of(run.commit) : options.title;
  run.release = options.release;
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
  command->callback([options] { add(*options); });
}

}  // namespace halfway::history
