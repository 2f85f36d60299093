#include "reports/history/gate/record.hpp"

#include "reports/cli/errors.hpp"
#include "reports/views/files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace halfway::gate {
namespace {

using nlohmann::json;
using statistics::Exact;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// null: a number that is none.
double number_at(const json& object, const char* key) {
  const json& value = object.at(key);
  return value.is_null() ? kNone : value.get<double>();
}

/// What has digits: an error that has a limit, or the distance from what was expected.
Exact exact_of(const json& finding) {
  const std::string comparison = finding.at("comparison");
  Exact out{.value = number_at(finding, "value")};
  out.verdict = statistics::verdict_of(finding.at("verdict").get<std::string>());
  if (comparison == "at_most") out.error = out.value;
  if (comparison == "equal") out.error = out.value - number_at(finding, "expected");
  if (comparison == "at_most" || comparison == "equal") out.limit = number_at(finding, "high");
  // The larger the better: a lower limit is the wider one.
  if (comparison == "at_least") out.limit = -number_at(finding, "low");
  if (comparison == "within") out.limit = number_at(finding, "high") - number_at(finding, "low");
  return out;
}

void add_timing(Record& record, const json& timing) {
  const std::string name = timing.at("name");
  const bool wrong = timing.at("wrong");
  const double ns = number_at(timing, "ns"), error = number_at(timing, "error");
  record.figures["time/" + name] = {{.value = ns}, wrong ? kNone : ns};
  record.figures["time/" + name + "/error"] = {
      {.value = error,
       .error = error,
       .verdict = wrong ? statistics::Verdict::fail : statistics::Verdict::pass}};
  const double flops = number_at(timing, "flops");
  if (flops > 0) record.figures["time/" + name + "/flops"] = {{.value = flops, .is_count = true}};
}

Record record_of(const json& root) {
  Record out;
  if (root.at("schema") != "halfway-results" || root.at("version") != 1)
    throw std::runtime_error("schema, version: not halfway-results, 1");
  const json& context = root.at("context");
  out.commit = context.at("commit");
  for (const char* key : {"machine", "compiler", "flags", "build_type"})
    out.series += (out.series.empty() ? "" : "; ") + context.at(key).get<std::string>();
  for (const json& finding : root.at("findings")) {
    const std::string name = finding.at("name");
    if (!out.figures.emplace(name, Figure{exact_of(finding)}).second)
      throw std::runtime_error(fmt::format("findings: two are named '{}'", name));
  }
  for (const json& timing : root.at("timings")) add_timing(out, timing);
  return out;
}

/// Of another series: what does not depend on how numbers are rounded.
Exact without_values(Exact exact) {
  exact.value = exact.error = 0;
  return exact;
}

void judge(Outcome& out, const std::string& name, const Exact& before, const Exact& after) {
  ++out.compared;
  if (const auto change = statistics::exact_change(before, after))
    out.lines.push_back({change->sense, name, change->text});
}

}  // namespace

Record read_report(const std::filesystem::path& path) {
  const auto file = std::filesystem::is_directory(path) ? path / "results.json" : path;
  try {
    Record out = record_of(json::parse(reports::read_file(file)));
    out.name = path.string();
    return out;
  } catch (const reports::FileError& error) {
    throw reports::BadInput(error.what());
  } catch (const std::exception& error) {
    throw reports::BadInput(fmt::format("{}: no results.json of a report: {}", file.string(), error.what()));
  }
}

Outcome compare(const Record& before, const Record& after) {
  Outcome out{
      .title = fmt::format("{} ({}) against {} ({})", after.name, after.commit, before.name, before.commit)};
  const bool same_series = before.series == after.series;
  if (!same_series)
    out.notes.push_back(
        fmt::format("verdicts and limits alone: not made alike ({} | {})", before.series, after.series));
  for (const auto& [name, old] : before.figures) {
    const auto found = after.figures.find(name);
    if (found == after.figures.end()) {
      out.lines.push_back({Sense::regression, name, "gone: nothing measures it any more"});
      continue;
    }
    if (old.ns != 0) continue;
    const Exact &a = old.exact, &b = found->second.exact;
    if (same_series)
      judge(out, name, a, b);
    else
      judge(out, name, without_values(a), without_values(b));
  }
  for (const auto& [name, figure] : after.figures) {
    if (before.figures.contains(name)) continue;
    const bool fails = figure.exact.verdict == statistics::Verdict::fail;
    out.lines.push_back({fails ? Sense::regression : Sense::change, name, fails ? "new, and fails" : "new"});
  }
  if (out.compared == 0) throw reports::FailedRun("nothing compared: no figure is on both sides");
  out.notes.push_back("times of two runs made apart are not judged; halfway gate measures both in turn");
  return out;
}

}  // namespace halfway::gate
