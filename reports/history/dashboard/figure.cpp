// Written as text at once: 10 000 runs of 464 times are five million numbers.
#include "reports/history/dashboard/dashboard.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace halfway::history {
namespace {

constexpr std::size_t kSpreadKept = 200;  ///< runs whose least and largest repetition are drawn

std::string four_digits(double x) { return std::isfinite(x) ? fmt::format("{:.4g}", x) : "null"; }
std::string all_digits(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "null"; }

std::string list(const std::vector<std::string>& items) { return fmt::format("[{}]", fmt::join(items, ",")); }

/// A row a run of the series, measured or not; least and largest repetitions of the last runs alone: those of
/// all would be two thirds of a large page.
std::string times_json(const History& h, int figure, int series, const std::vector<int>& runs) {
  std::vector<std::string> v, l, row_h;
  const auto& times = h.times[figure];
  auto at = times.begin();
  for (std::size_t i = 0; i < runs.size(); ++i) {
    while (at != times.end() && at->run < runs[i]) ++at;
    const bool is_there = at != times.end() && at->run == runs[i], is_late = i + kSpreadKept >= runs.size();
    v.push_back(is_there ? four_digits(at->time.ns()) : "null");
    if (!is_late) continue;
    l.push_back(is_there ? four_digits(at->time.low_ns()) : "null");
    row_h.push_back(is_there ? four_digits(at->time.high_ns()) : "null");
  }
  return fmt::format(R"({{"series":{},"r":null,"v":{},"l":{},"h":{}}})", series, list(v), list(l),
                     list(row_h));
}

std::string changes_json(const History& h, int figure, int series) {
  std::vector<std::string> r, v, limit, verdict;
  for (const ReadingAt& change : h.changes[figure]) {
    if (h.runs[change.run].series != series) continue;
    const Reading& x = change.reading;
    const bool is_judged =
        x.verdict == Verdict::pass || x.verdict == Verdict::fail || x.verdict == Verdict::known_failure;
    r.push_back(fmt::format("{}", change.run)), v.push_back(all_digits(x.value)),
        limit.push_back(all_digits(limit_of(x)));
    verdict.push_back(is_judged ? fmt::format("\"{}\"", to_string(x.verdict)) : "\"\"");
  }
  if (r.empty()) return "";
  const std::string start = fmt::format(R"({{"series":{},"r":{},"v":{})", series, list(r), list(v));
  if (h.figures[figure].kind == Kind::count) return start + "}";
  return fmt::format(R"({},"limit":{},"verdict":{}}})", start, list(limit), list(verdict));
}

}  // namespace

std::string figure_json(const History& h, int figure) {
  std::vector<std::vector<int>> runs(h.series.size());
  for (std::size_t i = 0; i < h.runs.size(); ++i) runs[h.runs[i].series].push_back(int(i));
  std::vector<std::string> out;
  for (int s = 0; s < int(h.series.size()); ++s) {
    const bool is_time = h.figures[figure].kind == Kind::time;
    const bool is_measured =
        std::ranges::any_of(h.times[figure], [&](const TimeAt& t) { return h.runs[t.run].series == s; });
    const std::string text = !is_time      ? changes_json(h, figure, s)
                             : is_measured ? times_json(h, figure, s, runs[s])
                                           : "";
    if (!text.empty()) out.push_back(text);
  }
  return fmt::format(R"({{"s":{}}})", list(out));
}

}  // namespace halfway::history
