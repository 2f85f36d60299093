// halfway dashboard: the history as one page.
#include "reports/history/dashboard/dashboard.hpp"

#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::history {
namespace {

struct DashboardOptions {
  std::string file = kFile, out = "out/dashboard.html";
};

void dashboard(const DashboardOptions& options) {
  const std::string command =
      "./halfway dashboard" + (options.file == kFile ? "" : " --file " + options.file);
  const std::string page = dashboard_html(load(options.file), command);
  reports::write_file(options.out, page);
  reports::print(fmt::format("wrote {}, {:.1f} MB\n", options.out, 1e-6 * double(page.size())));
}

}  // namespace

void add_dashboard(CLI::App& app) {
  const auto options = std::make_shared<DashboardOptions>();
  CLI::App* command =
      app.add_subcommand("dashboard", "One page of the history, which opens from the file system");
  add_file(*command, options->file);
  command->add_option("--out", options->out, "The page")->capture_default_str();
  command->callback([options] { dashboard(*options); });
}

}  // namespace halfway::history
