// halfway run of a chain: tip curves as of a joint, and the shapes.
#include "halfway/batch/batch.hpp"
#include "reports/cli/chain/chain_page.hpp"
#include "reports/cli/chain/shapes.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/interrupts.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/run/run_chart.hpp"
#include "reports/cli/run/run_files.hpp"
#include "reports/cli/run/run_options.hpp"
#include "reports/cli/run/run_page.hpp"
#include "reports/cli/run/summary.hpp"
#include "reports/cli/streams.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reports {
namespace {

Fit fit_of(const reference::ChainScene& scene) {
  const auto objection = [](const reference::Entry* entry) -> std::string {
    if (!entry) return "is of one joint alone";
    return batch::Batch::knows(entry->name) ? "" : "has no batch";
  };
  return {reference::choices(scene, [=](const reference::Entry& entry) { return objection(&entry).empty(); }),
          objection};
}

/// Files that are written already are whole.
void stop_if_interrupted(const reference::ChainScene& scene) {
  if (interrupted()) throw FailedRun(fmt::format("{}: interrupted", scene.name));
}

reference::ChainAnswer chain_answer(const reference::ChainScene& scene, const reference::Choice& choice) {
  Progress live(curve_label(reference::empty_curve(scene, choice)), Progress::Elsewhere::silent);
  reference::ChainAnswer out = reference::solve_chain_scene(scene, choice, [&](int done, int most) {
    live(done, most, "Newton iterations at most");
    return !interrupted();
  });
  stop_if_interrupted(scene);
  return out;
}

std::vector<reference::ChainAnswer> chain_answers(const reference::ChainScene& scene,
                                                  const std::vector<reference::Choice>& choices) {
  std::vector<reference::ChainAnswer> out;
  for (const auto& choice : choices) {
    out.push_back(chain_answer(scene, choice));
    const auto& curve = out.back().curve;
    tell(fmt::format("[{}/{}] {}: {}\n", out.size(), choices.size(), curve_label(curve), curve.outcome));
  }
  return out;
}

void write_answers(const RunOptions& options, const reference::ChainScene& scene,
                   const std::vector<reference::ChainAnswer>& answers,
                   const std::vector<reference::Curve>& curves, const std::vector<NotRun>& left_out) {
  const auto write = [&](std::string_view format, const char* name, const auto& content) {
    stop_if_interrupted(scene);
    if (options.wants(format)) write_result(options, scene, name, content());
  };
  write("csv", "curve.csv", [&] { return curves_csv(curves); });
  write("csv", "shape.csv", [&] { return shapes_csv(scene, answers); });
  write("json", "curve.json", [&] { return curves_json(scene, curves, left_out); });
  write("svg", "curve.svg", [&] { return curves_svg(scene, curves); });
  write("svg", "shape.svg", [&] { return shapes_svg(scene, answers); });
  write("html", "index.html", [&] {
    return run_page(chain_page_data(scene, {options.command(), curves, left_out}, answers));
  });
}

}  // namespace

void run_chain(const RunOptions& options, const reference::ChainScene& scene) {
  if (options.by_arc) throw BadInput(fmt::format("--arc: {} is a chain; allowed: a joint", scene.name));
  const Fit fit = fit_of(scene);
  const auto choices = run_choices(scene, fit, options.formulations, options.xis);
  begin_run(options, scene);
  catch_interrupts();
  const auto answers = chain_answers(scene, choices);
  std::vector<reference::Curve> curves;
  for (const auto& answer : answers) curves.push_back(answer.curve);
  const auto missing = options.formulations.empty() ? left_out(scene, fit, choices) : std::vector<NotRun>{};
  print(curves_table(scene, curves, missing));
  write_answers(options, scene, answers, curves, missing);
  print(summary_text(scene, curves, missing));
  if (std::ranges::none_of(curves, &reference::Curve::converged))
    throw FailedRun(
        fmt::format("{}: no formulation reached the last load factor {:g}", scene.name, scene.factor_end));
}

}  // namespace halfway::reports
