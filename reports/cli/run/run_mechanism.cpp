// halfway run of a mechanism: curves as of a joint.
#include "reference/mechanism/motion/solve_motion.hpp"
#include "reference/mechanism/solve.hpp"
#include "reports/cli/errors.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/run/energy_words.hpp"
#include "reports/cli/run/page_data.hpp"
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

Fit fit_of_mechanism(const reference::MechanismScene& scene) {
  return {reference::choices(scene), [&scene](const reference::Entry* entry) -> std::string {
            return entry ? reference::mechanism_objection(*entry, scene) : "is of one joint alone";
          }};
}

std::vector<reference::Curve> mechanism_curves(const reference::MechanismScene& scene,
                                               const std::vector<reference::Choice>& choices) {
  std::vector<reference::Curve> curves;
  for (const auto& choice : choices) {
    Progress live(curve_label(reference::empty_curve(scene, choice)), Progress::Elsewhere::silent);
    const auto told = [&](int done, int total) {
      live(done, total, fmt::format("{} {:g}", runs_over(scene), scene.factor_end * done / total));
    };
    curves.push_back(scene.time ? reference::solve_motion(scene, choice, told)
                                : reference::solve_scene(scene, choice, told));
    tell(fmt::format("[{}/{}] {}: {}\n", curves.size(), choices.size(), curve_label(curves.back()),
                     curves.back().outcome));
  }
  return curves;
}

}  // namespace

void run_mechanism(const RunOptions& options, const reference::MechanismScene& scene) {
  for (const auto& [asked, name] : {std::pair{options.by_arc, "--arc"}, {options.with_rod, "--rod"}})
    if (asked)
      throw BadInput(fmt::format("{}: {} is {}; allowed: one joint at rest", name, scene.name,
                                 scene.time
                                     ? "a motion, which has no path"
                                     : "a mechanism, which is followed in load steps; path.critical finds "
                                       "where its tangent is singular first"));
  const Fit fit = fit_of_mechanism(scene);
  const auto choices = run_choices(scene, fit, options.formulations, options.xis);
  begin_run(options, scene);
  const auto curves = mechanism_curves(scene, choices);
  const auto missing = options.formulations.empty() ? left_out(scene, fit, choices) : std::vector<NotRun>{};
  print(curves_table(scene, curves, missing));
  const auto write = [&](std::string_view format, const char* name, const auto& content) {
    if (options.wants(format)) write_result(options, scene, name, content());
  };
  write("csv", "curve.csv", [&] { return curves_csv(curves); });
  write("json", "curve.json", [&] { return curves_json(scene, curves, missing); });
  write("svg", "curve.svg", [&] { return curves_svg(scene, curves); });
  write("html", "index.html", [&] {
    return run_page(page_data(scene, {options.command(), curves, missing}));
  });
  print(summary_text(scene, curves, missing));
  if (scene.time) print(energy_words(scene, curves));
  if (std::ranges::any_of(curves, &reference::Curve::is_inaccurate))
    throw FailedRun(
        fmt::format("{}: beyond what double precision resolves; see the error column", scene.name));
  if (std::ranges::none_of(curves, &reference::Curve::converged))
    throw FailedRun(fmt::format("{}: no formulation reached the last {} {:g}", scene.name, runs_over(scene),
                                scene.factor_end));
}

}  // namespace halfway::reports
