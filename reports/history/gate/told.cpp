#include "reports/history/gate/told.hpp"

#include "reports/cli/errors.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

namespace halfway::gate {

void add_options(CLI::App& command, TellOptions& options) {
  command.add_flag("--all", options.all, "Show every change, not regressions and improvements alone");
  command.add_option("--markdown", options.markdown, "A summary for a pull request goes to this file");
  command
      .add_option("--annotations", options.service, "auto (by the environment), github, gitlab, azure, none")
      ->capture_default_str();
  command
      .add_option("--code-quality", options.code_quality, "GitLab's code quality report goes to this file")
      ->capture_default_str();
}

void check(const TellOptions& options) { service_of(options.service); }

void tell(const Outcome& outcome, const TellOptions& options) {
  const Service service = service_of(options.service);
  reports::print(as_text(outcome, options.all) + annotations(outcome, service));
  if (!options.markdown.empty()) reports::write_file(options.markdown, as_markdown(outcome));
  if (service == Service::gitlab) reports::write_file(options.code_quality, code_quality(outcome));
  const int worse = outcome.count(Sense::regression);
  if (worse > 0) throw reports::FailedRun(fmt::format("{} regression{}", worse, worse == 1 ? "" : "s"));
}

}  // namespace halfway::gate
