// halfway history prune: what is not needed any more.
#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"
#include "reports/history/store/store.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::history {
namespace {

struct PruneOptions {
  std::string file = kFile;
  int runs = -1, repetitions = -1;
};

void prune(const PruneOptions& options) {
  if (options.runs < 0 && options.repetitions < 0)
    throw reports::BadInput(
        "prune: says what to keep by --keep or --repetitions; without either nothing goes");
  if (!std::filesystem::exists(options.file)) throw reports::BadInput(options.file + ": no such file");
  const auto before = std::filesystem::file_size(options.file);
  with_store(options.file, Access::write,
             [&](Store& store) { store.prune(options.runs, options.repetitions); });
  reports::print(fmt::format("{}: {} kB, before {} kB\n", options.file,
                             std::filesystem::file_size(options.file) / 1000, before / 1000));
}

}  // namespace

void add_prune(CLI::App& history) {
  const auto options = std::make_shared<PruneOptions>();
  CLI::App* command =
      history.add_subcommand("prune", "Drop old runs or old repetitions; runs of a release stay");
  command->add_option("--keep", options->runs, "Runs to keep of each series")->check(CLI::Range(1, 1000000));
  command->add_option("--repetitions", options->repetitions, "Runs of each series that keep every repetition")
      ->check(CLI::Range(0, 1000000));
  add_file(*command, options->file);
  command->callback([options] { prune(*options); });
}

}  // namespace halfway::history
