#include "reports/views/tally.hpp"
#include "reports/views/writers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::reports {
namespace {

using reference::Finding;
using reference::Verdict;

constexpr const char* kKindNames[] = {"angular", "linear", "linear_angular"};
constexpr int kListedFailures = 20;  // one screen; all of them are in results.json and on the page

/// Markdown table cell: no pipes, no line breaks.
std::string cell(std::string text) {
  for (char& c : text)
    if (c == '|' || c == '\n') c = '/';
  return text;
}

std::string modelling_error(const Results& results, const std::string& formulation, const std::string& kind) {
  const Finding* f = find_finding(results, formulation + "/" + kind + "/modelling_error");
  if (!f || f->verdict == Verdict::left_out || !std::isfinite(f->value)) return "-";
  return f->value < f->uncertainty ? fmt::format("< {:.2g}", f->uncertainty)
                                   : fmt::format("{:.2g}", f->value);
}

/// Rotation up to which the joint follows the 3D block, degrees.
std::string degrees(const Results& results, const std::string& formulation, const std::string& percent) {
  const Finding* f = find_finding(results, formulation + "/angular/fe_degrees_" + percent + "_percent");
  return f == nullptr || !std::isfinite(f->value) ? "-" : fmt::format("{:.2g}", f->value);
}

/// Of the kernel; of the transcription, and said so, where there is none.
std::string nanoseconds(const Results& results, const std::string& formulation, const std::string& kind) {
  const bench::Timing* timing = find_timing(results, formulation, kind, "residual");
  if (!timing || !(timing->ns > 0 || timing->wrong)) return "-";
  if (timing->wrong) return "wrong";
  return fmt::format("{:.0f}{}", timing->ns, timing->implementation == "kernel" ? "" : " (transcription)");
}

std::string accuracy_table(const Results& results) {
  std::string text =
      "| formulation | modelling error at small angles: angular | linear | linear/angular | within 1 % of "
      "the 3D "
      "block up to, deg | 5 % | ns of the kernel's loads: angular | linear | linear/angular |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  for (const FormulationInfo& info : results.formulations) {
    text += "| `" + info.name + "` |";
    for (const char* kind : kKindNames) text += " " + modelling_error(results, info.name, kind) + " |";
    for (const char* percent : {"1", "5"}) text += " " + degrees(results, info.name, percent) + " |";
    for (const char* kind : kKindNames) text += " " + nanoseconds(results, info.name, kind) + " |";
    text += "\n";
  }
  return text;
}

/// Programs that were run, by their laws; nothing where none was.
std::string programs_table(const Results& results) {
  std::string rows;
  for (const auto& law : results.programs) {
    std::string defects;
    for (const auto& d : law.at("defects"))
      defects += fmt::format("{}{}: {:.2g}", defects.empty() ? "" : "; ", d.at("words").get<std::string>(),
                             d.at("size").get<double>());
    for (const auto& run : law.at("cases"))
      rows += fmt::format("| {} | {} | `{}` | {:.1f} | {} |\n", cell(run.at("program")),
                          cell(run.at("version")), law.at("name").get<std::string>(),
                          run.at("digits").get<double>(), defects.empty() ? "none found" : cell(defects));
  }
  if (rows.empty()) return "";
  return "## What real programs compute\n\n| program | version | law | agreement, digits | defects |\n"
         "|---|---|---|---|---|\n" +
         rows + "\n";
}

/// What the question "which joint for large angles?" gets for an answer.
std::string farthest(const Results& results) {
  const FormulationInfo* best = nullptr;
  double reach = 0;
  for (const FormulationInfo& info : results.formulations) {
    const Finding* f = find_finding(results, info.name + "/angular/fe_degrees_1_percent");
    if (f != nullptr && f->value > reach) best = &info, reach = f->value;
  }
  return best == nullptr
             ? "No range was measured."
             : fmt::format("No law is within 1 % beyond {:.2g} degrees (`{}`).", reach, best->name);
}

std::string failures(const Results& results) {
  std::string text;
  int listed = 0, all = 0;
  for (const Finding& finding : results.findings) {
    if (finding.verdict != Verdict::fail || ++all > kListedFailures) continue;
    text += fmt::format("- `{}`: {}\n", finding.name, cell(explain(finding)));
    ++listed;
  }
  for (const bench::Timing& timing : results.timings)
    if (timing.wrong) text += fmt::format("- `{}` (benchmark): {}\n", timing.name, cell(timing.message));
  if (all > listed) text += fmt::format("- and {} more, see results.json\n", all - listed);
  return text.empty() ? "Nothing failed.\n" : text;
}

/// Left out, one line per reason: the same reason often holds for many names.
std::string left_out(const Results& results) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;
  const auto add = [&](const std::string& what, const std::string& reason) {
    for (auto& [known, names] : by_reason)
      if (known == reason) return names.push_back(what);
    by_reason.push_back({reason, {what}});
  };
  for (const LeftOut& item : results.left_out) add(item.what, item.reason);
  for (const Finding& finding : results.findings)
    if (finding.verdict == Verdict::left_out) add(finding.name, finding.reason);

  std::string text;
  for (const auto& [reason, names] : by_reason) {
    const std::string more = names.size() > 1 ? fmt::format(" and {} more", names.size() - 1) : "";
    text += fmt::format("- `{}`{}: {}\n", names.front(), more, cell(reason));
  }
  return text.empty() ? "Nothing was left out.\n" : text;
}

}  // namespace

std::string summary_markdown(const Results& results) {
  const Tally all = tally(results.findings);
  const bench::Context& c = results.context;
  return fmt::format(
      "# Halfway: summary\n\n"
      "{} findings: **{} passed, {} failed**, {} known failures inside their bands, {} left out.\n\n"
      "{}\n"
      "Modelling error: of the second-order coupling that mirror symmetry dictates, at phi = 0.09 deg "
      "(angular) and a "
      "strain of 2.6 %; `<` marks an error below the uncertainty of the truth itself. About large angles it "
      "says "
      "nothing; the next two columns do: each component of the rotation vector of the block of Table 2 under "
      "a skewed moment, against nonlinear 3D finite elements (D : ln V). {} Loads are internal, q = dU/dx: "
      "add -q to the "
      "equations of "
      "motion.\n\n"
      "{}## Failed\n\n{}\n## Left out\n\n{}\n"
      "Machine: {}; {} {}; {}; commit {}; {}. Reproduce with `{}`.\n",
      all.total(), all.pass, all.fail, all.known_failure, all.left_out, accuracy_table(results),
      farthest(results), programs_table(results), failures(results), left_out(results), c.machine, c.compiler,
      c.flags, c.build_type, c.commit, c.date, results.command);
}

}  // namespace halfway::reports
