// halfway run: one scene, solved with each formulation; its curves as CSV, JSON and SVG. Of chains see
// run_chain.cpp.
#include "reference/scene/joint/names.hpp"
#include "reference/solve/free_directions.hpp"
#include "reference/solve/paths/arc_curve.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/run/rod_curve.hpp"
#include "reports/cli/run/run_chart.hpp"
#include "reports/cli/run/run_files.hpp"
#include "reports/cli/run/run_options.hpp"
#include "reports/cli/run/run_page.hpp"
#include "reports/cli/run/summary.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>
#include <optional>

namespace halfway::reports {
namespace {

void check_formats(const std::vector<std::string>& formats) {
  const std::vector<std::string_view> allowed = {"csv", "json", "svg", "html"};
  for (const std::string& format : formats) {
    if (std::ranges::find(allowed, format) == allowed.end())
      throw BadInput(reference::unknown_name("format", format, allowed));
  }
}

/// One path, its load factor live on a terminal.
reference::Curve solve_stiff(const RunOptions& options, const reference::Scene& scene,
                             const reference::Choice& choice) {
  if (options.by_arc) return reference::follow_by_arc(scene, choice);
  Progress live(curve_label(reference::empty_curve(scene, choice)), Progress::Elsewhere::silent);
  return reference::solve_scene(scene, choice, [&](int done, int total) {
    live(done, total, fmt::format("load factor {:g}", scene.factor_end * done / total));
  });
}

/// A joint with directions of no stiffness is held there, by one stiffness and by another: where no load
/// works there, they make no difference.
reference::Curve solve(const RunOptions& options, const reference::Scene& scene,
                       const reference::Choice& choice) {
  const auto softly = reference::held(scene, 1), firmly = reference::held(scene, 8);
  if (!softly) return solve_stiff(options, scene, choice);
  reference::Curve curve = solve_stiff(options, *softly, choice);
  if (curve.converged && !reference::agree(curve, solve_stiff(options, *firmly, choice))) {
    curve.converged = false;
    curve.cause = "a free direction: once displaced, the load works on it, and no stiffness balances that";
    curve.outcome = "no equilibrium: once displaced, the load works on a direction without stiffness";
  }
  return curve;
}

std::vector<reference::Curve> solve_all(const RunOptions& options, const reference::Scene& scene,
                                        const std::vector<reference::Choice>& choices) {
  std::vector<reference::Curve> curves;
  for (const auto& choice : choices) {
    curves.push_back(solve(options, scene, choice));
    curves.back().critical = reference::critical_state(scene, choice);
    tell(fmt::format("[{}/{}] {}: {}\n", curves.size(), choices.size(), curve_label(curves.back()),
                     curves.back().outcome));
  }
  return curves;
}

void write_curves(const RunOptions& options, const reference::Scene& scene,
                  const std::vector<reference::Curve>& curves, const std::vector<NotRun>& left_out) {
  const auto write = [&](const char* name, const std::string& content) {
    write_result(options, scene, name, content);
  };
  if (options.wants("csv")) write("curve.csv", curves_csv(curves));
  if (options.wants("csv") && scene.critical_axis != 0) write("critical.csv", critical_csv(scene, curves));
  if (options.wants("json")) write("curve.json", curves_json(scene, curves, left_out));
  if (options.wants("svg")) write("curve.svg", curves_svg(scene, curves));
  if (options.wants("html"))
    write("index.html", run_page(page_data(scene, {options.command(), curves, left_out})));
}

void run_joint(const RunOptions& options, const reference::Scene& scene) {
  if (const auto why = reference::works_on_free_direction(scene))
    throw BadInput(fmt::format("{}: no equilibrium: {}", scene.name, *why));
  const Fit fit = fit_of(scene);
  const auto choices = run_choices(scene, fit, options.formulations, options.xis);
  const auto rod = options.with_rod ? std::optional(rod_curve(scene)) : std::nullopt;
  begin_run(options, scene);
  auto curves = solve_all(options, scene, choices);
  if (rod) curves.push_back(*rod);
  const auto missing = options.formulations.empty() ? left_out(scene, fit, choices) : std::vector<NotRun>{};
  print(curves_table(scene, curves, missing));
  write_curves(options, scene, curves, missing);
  print(summary_text(scene, curves, missing));
  if (std::ranges::any_of(curves, &reference::Curve::is_inaccurate))
    throw FailedRun(
        fmt::format("{}: beyond what double precision resolves; see the error column", scene.name));
  // The linear analysis always does: it is an answer only where nothing else was asked for.
  const auto is_linear = [](const reference::Curve& c) { return c.formulation == reference::kLinearized; };
  const bool asked_for_more = !std::ranges::all_of(curves, is_linear);
  if (std::ranges::none_of(curves,
                           [&](const auto& c) { return c.converged && !(asked_for_more && is_linear(c)); }))
    throw FailedRun(
        fmt::format("{}: no formulation reached the last load factor {:g}", scene.name, scene.factor_end));
}

void run(const RunOptions& options, RunChain run_chain) {
  check_formats(options.formats);
  const reference::AnyScene scene = find_scene(options.scene);
  const auto* chain = std::get_if<reference::ChainScene>(&scene);
  if (chain && options.with_rod)
    throw BadInput(fmt::format("--rod: scene {} is a chain already", options.scene));
  if (chain && !run_chain)
    throw BadInput(
        fmt::format("scene {} is a chain: ./halfway run solves it, by a program of its own (halfway-chains)",
                    options.scene));
  if (chain) return run_chain(options, *chain);
  if (const auto* mechanism = std::get_if<reference::MechanismScene>(&scene))
    return run_mechanism(options, *mechanism);
  run_joint(options, std::get<reference::Scene>(scene));
}

}  // namespace

bool RunOptions::wants(std::string_view format) const {
  return formats.empty() || std::ranges::find(formats, format) != formats.end();
}

std::string RunOptions::command() const {
  std::string out = fmt::format("./halfway run {}", scene);
  if (!formulations.empty()) out += fmt::format(" --formulation {}", fmt::join(formulations, ","));
  if (!xis.empty()) out += fmt::format(" --xi {}", fmt::join(xis, ","));
  if (by_arc) out += " --arc";
  if (with_rod) out += " --rod";
  return out;
}

void begin_run(const RunOptions& options, const reference::SceneHead& scene) {
  try_output((std::filesystem::path(options.folder) / scene.name).string());
  print(printable(fmt::format("{}: {}", scene.name, scene.title)) + "\n");
  for (const std::string& note : scene.notes) tell("halfway: note: " + printable(note) + "\n");
}

void write_result(const RunOptions& options, const reference::SceneHead& scene, const char* name,
                  const std::string& content) {
  const auto file = std::filesystem::path(options.folder) / scene.name / name;
  write_file(file, content);
  print("wrote " + printable(file.string()) + "\n");
}

void add_run(CLI::App& app, RunChain run_chain) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* command = app.add_subcommand("run", "Solve one scene, write its curves and a page");
  command->add_option("scene", options->scene, "Name of a canonical scene, or a TOML file")->required();
  command->add_option("--formulation", options->formulations, "Formulations, separated by commas")
      ->delimiter(',');
  command->add_option("--xi", options->xis, "Values of the free xi, separated by commas")->delimiter(',');
  command->add_option("--format", options->formats, "csv, json, svg, html; default: all")->delimiter(',');
  command->add_flag("--arc", options->by_arc,
                    "Follow paths by arc length: on through folds, all singular points named");
  command->add_flag("--rod", options->with_rod,
                    "Of an angular joint also the slender rod of its stiffness, to all orders");
  command->add_option("--out", options->folder, "Folder; the curves go to FOLDER/SCENE/")
      ->capture_default_str();
  command->callback([options, run_chain] { run(*options, run_chain); });
}

}  // namespace halfway::reports
