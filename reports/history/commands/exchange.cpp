// halfway history export, import.
#include "reports/history/exchange/exchange.hpp"

#include "reports/cli/streams.hpp"
#include "reports/history/commands/commands.hpp"
#include "reports/history/exchange/lines.hpp"
#include "reports/history/store/store.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::history {
namespace {

struct ExportOptions {
  std::string format = "jsonl", run, figure, out, file = kFile;
};

/// jsonl and csv are of all runs unless one is named, the others of one: the last unless one is named.
std::string exported(const History& history, const ExportOptions& options) {
  const auto is_wanted = matcher(options.figure);
  const bool is_of_all = options.run.empty() && (options.format == "jsonl" || options.format == "csv");
  const int run = is_of_all ? -1 : chosen_run(history, options.run);
  if (options.format == "jsonl") {
    if (!options.figure.empty())
      throw reports::BadInput("--figure: jsonl has every figure; csv takes a choice");
    return json_lines(history, run);
  }
  if (options.format == "csv") return csv(history, run, is_wanted);
  const Selection selection = select(history, run, is_wanted);
  if (options.format == "google") return google_json(selection);
  if (options.format == "github") return github_json(selection);
  if (options.format == "bmf") return bmf_json(selection);
  if (options.format == "openmetrics") return open_metrics(selection);
  if (options.format == "junit") return junit_xml(selection);
  return ctest_measurements(selection, !options.figure.empty());
}

void run_export(const ExportOptions& options) {
  const std::string text = exported(load(options.file), options);
  if (options.out.empty())
    reports::print(text);
  else
    reports::write_file(options.out, text);
}

void run_import(const std::string& from, const std::string& file) {
  std::string text;
  try {
    text = reports::read_file(from);
  } catch (const reports::FileError& error) {
    throw reports::BadInput(error.what());
  }
  // Read to its end before anything is written.
  std::vector<Record> records;
  read_lines(text, from, [&](const Record& record) { records.push_back(record); });
  int added = 0;
  with_store(file, Access::write, [&](Store& store) {
    for (const Record& record : records) added += !store.add(record).was_there;
  });
  reports::print(fmt::format("{} runs, {} of them new\n", records.size(), added));
}

}  // namespace

void add_export(CLI::App& history) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = history.add_subcommand("export", "The history in the form that another program reads");
  command
      ->add_option(
          "--format", options->format,
          "jsonl: everything, for import; csv; of one run: google "
          "(compare.py), github (github-action-benchmark, customBiggerIsBetter), bmf (Bencher), openmetrics, "
          "junit, ctest (at most ten measurements)")
      ->capture_default_str()
      ->check(CLI::IsMember({"jsonl", "csv", "google", "github", "bmf", "openmetrics", "junit", "ctest"}));
  command->add_option("--run", options->run,
                      "Number of a run, or the beginning of a commit; default: the last run");
  command->add_option("--figure", options->figure, "Regular expression over figures; default: all");
  command->add_option("--out", options->out, "File; default: standard output");
  add_file(*command, options->file);
  command->callback([options] { run_export(*options); });
}

void add_import(CLI::App& history) {
  const auto from = std::make_shared<std::string>(), file = std::make_shared<std::string>(kFile);
  CLI::App* command = history.add_subcommand("import", "Add the runs of another history, exported as jsonl");
  command->add_option("from", *from, "The exported file")->required();
  add_file(*command, *file);
  command->callback([from, file] { run_import(*from, *file); });
}

}  // namespace halfway::history
