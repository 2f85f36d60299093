// halfway reference: computes the kept 3D results again where their inputs changed.
#include "reference/truth/data.hpp"
#include "reference/truth/fe/studies/studies.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::reports {
namespace {

namespace fe = reference::fe;

struct ReferenceOptions {
  std::vector<std::string> names;
  bool force = false;
};

std::vector<const fe::Study*> chosen(const ReferenceOptions& options) {
  std::vector<const fe::Study*> out;
  try {
    for (const auto& name : options.names) out.push_back(&fe::study_named(name));
  } catch (const std::invalid_argument& e) {
    throw BadInput(e.what());
  }
  if (out.empty()) {
    for (const auto& study : fe::studies()) out.push_back(&study);
  }
  return out;
}

void reference_command(const ReferenceOptions& options) {
  for (const fe::Study* study : chosen(options)) {
    if (!options.force && fe::kept(*study)) {
      print(fmt::format("{}: up to date\n", study->name));
      continue;
    }
    const auto json = fe::regenerate(*study, Progress(study->name));
    const auto file = reference::data_folder() / fe::file_of(*study);
    std::filesystem::create_directories(file.parent_path());
    write_file(file, json.dump() + "\n");
    print(fmt::format("{}: written to {}\n", study->name, file.string()));
  }
}

}  // namespace

void add_reference(CLI::App& app) {
  const auto options = std::make_shared<ReferenceOptions>();
  CLI::App* command =
      app.add_subcommand("reference", "Compute the three-dimensional truth again where its inputs changed");
  command->add_option("names", options->names, "Studies; all when none is named");
  command->add_flag("--force", options->force, "Also those that are up to date");
  command->callback([options] { reference_command(*options); });
}

}  // namespace halfway::reports
