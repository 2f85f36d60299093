// halfway advise: which joint a scene needs, and no more.
#include "reports/advise/command.hpp"

#include "reports/advise/views/charts.hpp"
#include "reports/advise/views/json.hpp"
#include "reports/advise/views/page.hpp"
#include "reports/advise/views/words.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/run/run_choices.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <memory>

namespace halfway::advise {
namespace {

using reports::BadInput;

struct Options {
  std::string scene;
  double tolerance = 1e-2;
  std::string truth = "auto", measure;
  std::optional<double> degrees;
  double periods = 0;
  bool json = false, moving = false;
  std::string folder = "out/advise";

  std::string command() const {
    std::string out = fmt::format("./halfway advise {} --tolerance {:g}", scene, tolerance);
    if (truth != "auto") out += " --truth " + truth;
    if (degrees) out += fmt::format(" --degrees {:g}", *degrees);
    if (!measure.empty()) out += " --measure " + measure;
    if (moving) out += " --moving";
    if (periods > 0) out += fmt::format(" --periods {:g}", periods);
    return out;
  }
};

reference::Scene scene_of(const Options& options) {
  auto any = reports::find_scene(options.scene);
  if (auto* scene = std::get_if<reference::Scene>(&any)) return std::move(*scene);
  const bool chain = std::holds_alternative<reference::ChainScene>(any);
  throw BadInput(fmt::format("{}: a scene of {}; allowed: a scene of one joint between two nodes",
                             options.scene, chain ? "a chain" : "a mechanism"));
}

std::optional<Measure> measure_of(const std::string& name) {
  if (name.empty()) return std::nullopt;
  for (const Measure measure : {Measure::norm, Measure::each})
    if (name == to_string(measure)) return measure;
  throw BadInput(
      fmt::format("--measure {}: allowed: norm (|theta| and |u|), each (output over itself)", name));
}

/// index.html, advice.json and, of truths that have one, map.csv.
void write(const Options& options, const Advice& advice, const std::vector<MapColumn>& map) {
  const auto folder = std::filesystem::path(options.folder) / advice.question.scene.name;
  const auto put = [&](const char* name, const std::string& text) {
    reports::write_file(folder / name, text);
    reports::print("wrote " + reports::printable((folder / name).string()) + "\n");
  };
  put("advice.json",
      advice_json(advice).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
  if (!map.empty()) put("map.csv", map_csv(map));
  put("index.html", advice_page(advice, map, options.command()));
}

void run(const Options& options) {
  Question question;
  question.scene = scene_of(options);
  question.tolerance = options.tolerance;
  question.truth = options.truth;
  question.degrees = options.degrees;
  question.measure = measure_of(options.measure);
  question.periods = options.periods;
  question.is_moving = options.moving;
  for (const std::string& note : question.scene.notes)
    reports::tell("halfway: note: " + reports::printable(note) + "\n");
  reference::complete_catalog();
  if (!options.json)
    reports::try_output((std::filesystem::path(options.folder) / question.scene.name).string());
  Advice advice = asked(question);  // first of all: what is wrong with it is said at once
  const auto costs = costs_of(question.scene);
  answer(advice, costs);
  advice.margin = margin_of(advice, costs);
  if (options.json) {
    reports::print(advice_json(advice).dump(1, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
    return;
  }
  reports::print(reports::printable(fmt::format("{}: {}", question.scene.name, question.scene.title)) + "\n");
  reports::print(summary_text(advice));
  write(options, advice, adequacy_map(advice, costs));
}

}  // namespace

void add_advise(CLI::App& app) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("advise", "Which joint does a scene need, and no more?");
  command->add_option("scene", options->scene, "Name of a canonical scene, or a TOML file")->required();
  command->add_option("--tolerance", options->tolerance, "How far from the truth, relative")
      ->capture_default_str();
  command
      ->add_option("--truth", options->truth,
                   "auto, rod, chain:N, body, form, none, or NAME.csv (factor, outputs)")
      ->capture_default_str();
  command->add_option("--degrees", options->degrees,
                      "Ends the envelope where the joint has turned so far; else at the scene's load");
  command->add_option("--measure", options->measure, "norm or each; default: what the truth is looked at by");
  command
      ->add_option("--periods", options->periods,
                   "Periods of a motion, over which energy that a law makes adds up")
      ->capture_default_str();
  command->add_flag("--moving", options->moving, "Node a turns as well: no linear analysis");
  command->add_flag("--json", options->json, "For programs, on standard output; nothing is written");
  command->add_option("--out", options->folder, "Folder; the page goes to FOLDER/SCENE/")
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace halfway::advise
