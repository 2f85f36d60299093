// halfway report: verifies, solves the scenes, times, and writes the page and its data.
#include "bench/harness/timing.hpp"
#include "bench/questions/methods/skipped.hpp"
#include "reference/record/effort.hpp"
#include "reference/scene/joint/names.hpp"
#include "reports/cli/commands.hpp"
#include "reports/cli/progress.hpp"
#include "reports/cli/streams.hpp"
#include "reports/views/paper.hpp"
#include "reports/views/programs.hpp"
#include "reports/views/rods/rods.hpp"
#include "reports/views/solids.hpp"
#include "reports/views/speed.hpp"
#include "reports/views/stability/stability.hpp"
#include "reports/views/writers.hpp"
#include "verify/check.hpp"
#include "verify/oracle/saboteurs/matrix.hpp"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cmath>
#include <memory>

namespace halfway::reports {
namespace {

struct ReportOptions {
  std::string folder = "out/report";
  bool quick = false;
  std::string only;  ///< one formulation; empty: all
};

/// Loads and tangents of single joints.
constexpr const char* kQuickBenchmarks =
    "^[a-z_0-9]+/(angular|linear|linear_angular)/residual(_tangent)?(/kernel)?$";
constexpr const char* kQuickReason = "this report is quick, or of one formulation: ./halfway report has it";

/// Findings, checks and benchmarks of one formulation start with its name.
bool wanted(const ReportOptions& options, const std::string& name) {
  return options.only.empty() || name.starts_with(options.only + "/");
}

/// Wall time of a stage, s.
template <class Work>
double timed(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// A check that threw is a failed finding of its name, not the end of the report.
std::vector<reference::Finding> findings_of(const verify::Check& check) {
  try {
    return check.run();
  } catch (const std::exception& e) {
    return {reference::finding(check.name)
                .about(check.name.substr(0, check.name.find('/')))
                .at_most(0, e.what())};
  }
}

void verify_all(const ReportOptions& options, Results& results) {
  verify::Checks checks = verify::all_checks();
  std::erase_if(checks, [&](const verify::Check& check) {
    return !wanted(options, check.name) || (options.quick && check.name.starts_with("saboteurs/"));
  });
  if (options.quick) results.left_out.push_back({"that every check can fail (saboteurs)", kQuickReason});
  if (reference::is_quick())
    results.left_out.push_back(
        {"most samples of the expensive checks", "HALFWAY_EFFORT=quick, as ./halfway sets it for --quick"});
  Progress progress("verifying");
  int done = 0;
  for (const verify::Check& check : checks) {
    for (const auto& finding : findings_of(check)) results.findings.push_back(finding);
    progress(++done, int(checks.size()), check.name);
  }
  results.findings.push_back(reference::named_once(results.findings));
  results.saboteurs = verify::computed_rows();
  for (const auto& f : results.findings) {
    if (f.verdict == reference::Verdict::left_out) results.left_out.push_back({f.name, f.reason});
  }
}

void solve_all(const ReportOptions& options, Results& results) {
  const auto scenes = reference::canonical_scenes();
  results.scenes = scene_infos(scenes);
  Progress progress("solving");
  int done = 0;
  for (const auto& scene : scenes) {
    for (const auto& choice : reference::choices(scene)) {
      if (!options.only.empty() && (choice.entry == nullptr || choice.entry->name != options.only)) continue;
      const auto curve = reference::solve_scene(scene, choice);
      if (!curve.converged) {
        results.left_out.push_back(
            {fmt::format("{}/{}, the rest of the path", scene.name, curve.formulation), curve.outcome});
      }
      results.curves.push_back(curve);
    }
    progress(++done, int(scenes.size()), scene.name);
  }
}

void time_all(const ReportOptions& options, Results& results) {
  bench::Options bench_options;
  bench_options.json_file = options.folder + "/bench.json";
  if (options.quick) {
    bench_options.repetitions = 2;
    bench_options.min_time = 0.001;
  }
  if (!options.only.empty()) {
    bench_options.filter = "^" + options.only + "/";
  } else if (options.quick) {
    bench_options.filter = kQuickBenchmarks;
    results.left_out.push_back({"times of batches, variants, methods and equilibria", kQuickReason});
  }
  const bench::Run run = bench::run(bench_options, Progress("timing"));
  results.context = run.context;
  results.timings = run.timings;
  for (const auto& timing : results.timings) {
    if (timing.wrong) results.left_out.push_back({timing.name, "not timed: " + timing.message});
  }
  for (const auto& [what, reason] : bench::skipped()) results.left_out.push_back({what, reason});
  results.speed = speed_record(results, run);
}

int count(const Results& results, reference::Verdict verdict) {
  return int(std::ranges::count(results.findings, verdict, &reference::Finding::verdict));
}

void report(const ReportOptions& options) {
  if (!options.only.empty() && reference::find_formulation(options.only) == nullptr)
    throw BadInput(reference::unknown_name("formulation", options.only, reference::formulation_names()));
  try_output(options.folder);
  const FolderLock lock(options.folder);
  Results results;
  results.command = std::string("./halfway report") + (options.quick ? " --quick" : "") +
                    (options.only.empty() ? "" : " --formulation " + options.only);
  results.formulations = formulation_infos();
  results.paper = paper_record();
  results.solids = solids_record();
  for (auto& curve : solid_reference_curves()) results.paper["reference_curves"].push_back(std::move(curve));
  for (auto& curve : c3_reference_curves()) results.paper["reference_curves"].push_back(std::move(curve));
  for (const auto& missing : results.solids.at("missing")) {
    results.left_out.push_back(
        {missing.at("what"), "its kept data is missing or stale: run ./halfway reference"});
  }
  results.durations["verify"] = timed([&] { verify_all(options, results); });
  results.programs = programs_record(results.findings);
  results.durations["solve"] = timed([&] { solve_all(options, results); });
  if (options.only.empty() && !options.quick) {
    results.durations["stability"] =
        timed([&] { results.stability = stability_record(Progress("where methods fail")); });
    results.durations["rods"] = timed([&] { results.rods = rods_record(Progress("large rotation")); });
  } else {
    results.left_out.push_back({"where methods fail", kQuickReason});
    results.left_out.push_back({"who follows the rod at large rotation", kQuickReason});
  }
  results.durations["time"] = timed([&] { time_all(options, results); });
  write_report(results, options.folder);

  const int failed = count(results, reference::Verdict::fail);
  const auto wrong = std::ranges::count(results.timings, true, &bench::Timing::wrong);
  print(fmt::format(
      "{} findings: {} pass, {} known failures in their bands, {} left out, {} fail; {} timings\n",
      results.findings.size(), count(results, reference::Verdict::pass),
      count(results, reference::Verdict::known_failure), count(results, reference::Verdict::left_out), failed,
      results.timings.size() - wrong));
  print(
      fmt::format("wrote {0}/index.html, results.json, summary.md, junit.xml, bench.json\n", options.folder));
  if (failed > 0 || wrong > 0) {
    throw FailedRun(fmt::format("{} findings failed and {} benchmarks were wrong; see {}/summary.md", failed,
                                wrong, options.folder));
  }
}

}  // namespace

void add_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App* command = app.add_subcommand("report", "Verify, solve, time, and write out/report/index.html");
  command->add_option("--out", options->folder, "Folder of the report")->capture_default_str();
  command->add_flag("--quick", options->quick,
                    "A first look: single joints timed, and briefly; says what it leaves out");
  command->add_option("--formulation", options->only, "A report of this formulation alone");
  command->callback([options] { report(*options); });
}

}  // namespace halfway::reports
