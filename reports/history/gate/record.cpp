#include "reports/history/gate/record.hpp"

#include "reports/cli/errors.hpp"
#include "reports/history/intake/intake.hpp"
#include "reports/history/record/exact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace halfway::gate {
namespace {

using statistics::Exact;

/// Of another series: what does not depend on how numbers are rounded.
Exact without_values(Exact exact) {
  exact.value = exact.error = 0;
  return exact;
}

/// A run computes some limits from its own numbers (drifts, by the steps it took). From one instruction set
/// to another those moved by up to a half; what somebody widened by less than this factor is not told from
/// them.
constexpr double kOwnLimits = 2;

bool are_near(double a, double b) { return a > 0 && b > 0 && std::max(a, b) <= kOwnLimits * std::min(a, b); }

/// A figure that only machines with that instruction set have: .../batch/avx2/..., .../batch_avx512_residual.
bool names_instruction_set(std::string_view name) {
  constexpr std::string_view kNames[] = {"sse2", "avx2", "avx2vl", "avx512"};
  while (!name.empty()) {
    const std::size_t end = std::min(name.find_first_of("/_"), name.size());
    if (std::ranges::find(kNames, name.substr(0, end)) != std::end(kNames)) return true;
    name.remove_prefix(std::min(end + 1, name.size()));
  }
  return false;
}

/// What two runs have in common, and so how far they are compared.
struct Likeness {
  bool series = false, machine = false;
};

void judge(Outcome& out, const std::string& name, const Exact& before, const Exact& after, Likeness same) {
  ++out.compared;
  const auto change = same.series ? statistics::exact_change(before, after)
                                  : statistics::exact_change(without_values(before), without_values(after));
  if (!change) return;
  // A step more of an iteration may be another rounding in a library that chooses its code by processor.
  const bool is_own_limit =
      !same.series && before.verdict == after.verdict && are_near(before.limit, after.limit);
  const bool is_judged = (same.machine || !after.is_count) && !is_own_limit;
  out.lines.push_back({is_judged ? change->sense : Sense::change, name, change->text});
}

Likeness likeness(Outcome& out, const Record& before, const Record& after) {
  const Likeness same{before.series == after.series, before.machine == after.machine};
  if (!same.series)
    out.notes.push_back(
        fmt::format("verdicts and limits alone: not made alike ({} | {})", before.series, after.series));
  else if (!same.machine)
    out.notes.push_back(
        fmt::format("counts are not judged: of another processor ({} | {})", before.machine, after.machine));
  return same;
}

}  // namespace

Record record_of(const history::Record& run, const std::string& name) {
  const history::Series& s = run.series;
  Record out{.name = name,
             .commit = run.run.commit + (run.run.dirty ? "+changes" : ""),
             .series = fmt::format("{}; {}; {}; {}", s.compiler, s.flags, s.build_type, s.isa),
             .machine = s.machine.cpu,
             .is_partial = run.is_partial};
  for (const auto& [figure, exact] : run.exact)
    out.figures[figure] = history::exact_of(exact.figure, exact.reading);
  return out;
}

Record read_report(const std::filesystem::path& path) {
  // The file itself: repetitions of times, which lie beside it, are not compared.
  const auto file = path / "results.json";
  return record_of(history::read_report(std::filesystem::is_regular_file(file) ? file : path).record,
                   path.string());
}

Outcome compare(const Record& before, const Record& after) {
  Outcome out{
      .title = fmt::format("{} ({}) against {} ({})", after.name, after.commit, before.name, before.commit)};
  const Likeness same = likeness(out, before, after);
  int lacking = 0;
  for (const auto& [name, old] : before.figures) {
    const auto found = after.figures.find(name);
    if (found != after.figures.end())
      judge(out, name, old, found->second, same);
    else if (after.is_partial)
      ++lacking;
    else if (!same.series && names_instruction_set(name))
      out.lines.push_back(
          {Sense::change, name, "gone: of an instruction set, and the runs were not made alike"});
    else
      out.lines.push_back({Sense::regression, name, "gone: nothing measures it any more"});
  }
  for (const auto& [name, exact] : after.figures) {
    if (before.figures.contains(name)) continue;
    const bool fails = exact.verdict == statistics::Verdict::fail;
    out.lines.push_back({fails ? Sense::regression : Sense::change, name, fails ? "new, and fails" : "new"});
  }
  if (out.compared == 0) throw reports::FailedRun("nothing compared: no figure is on both sides");
  if (lacking > 0)
    out.notes.push_back(fmt::format("not in the partial report of {}: {} of {} figures", after.name, lacking,
                                    before.figures.size()));
  out.notes.push_back("times of two runs made apart are not judged; halfway gate measures both in turn");
  return out;
}

}  // namespace halfway::gate
