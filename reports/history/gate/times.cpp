#include "reports/history/gate/times.hpp"

#include "reports/history/statistics/medians.hpp"
#include "reports/history/statistics/rank_test.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>

namespace halfway::gate {
namespace {

using Clock = std::chrono::steady_clock;

std::string time_left(Clock::time_point begin, int done, int to_go) {
  if (done == 0) return "";
  const double each = std::chrono::duration<double>(Clock::now() - begin).count() / done;
  return fmt::format("about {:.0f} s left", each * to_go);
}

constexpr double kApart = 0.1;  // layouts that are not apart differ by up to 5 %, a slow one by 20 to 30

/// Which layout each sample of a figure is of.
struct Layouts {
  std::vector<int> base, head;
};

void include(Table& table, std::map<std::string, Layouts>& layouts, const Reading& reading, bool head,
             int layout) {
  for (const auto& [name, f] : reading) {
    Samples& s = table[name];
    (head ? s.head : s.base).push_back(f.ns);
    (head ? layouts[name].head : layouts[name].base).push_back(layout);
    (head ? s.head_error : s.base_error) = f.error;
    if (!f.wrong.empty()) (head ? s.head_wrong : s.base_wrong) = f.wrong;
  }
}

/// Every layout of one side meets every one of the other.
int layout_of(const Side& side, int pair, bool head) {
  const int n = int(side.programs.size());
  return (pair + (head ? pair / n : 0)) % n;
}

}  // namespace

double TimeRules::allowed_of(const std::string& figure) const {
  const auto found = allowed.find(figure);
  return found == allowed.end() || found->second < least ? least : found->second;
}

Compared compared(const std::vector<double>& base, const std::vector<double>& head) {
  Compared out{statistics::median(base), statistics::median(head)};
  out.ratio = out.head / out.base;
  if (std::isnan(out.ratio)) return out;
  out.slower = statistics::chance_of_higher(base, head);
  out.faster = statistics::chance_of_higher(head, base);
  return out;
}

bool is_slower(const Compared& c, const TimeRules& rules, double allowed) {
  return c.slower < rules.chance && c.ratio > 1 + allowed;
}
bool is_faster(const Compared& c, const TimeRules& rules, double allowed) {
  return c.faster < rules.chance && 1 / c.ratio > 1 + allowed;
}

bool comes_again(const Samples& first, const Samples& again, const TimeRules& rules, double allowed) {
  const auto together = [](std::vector<double> a, const std::vector<double>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  return compared(again.base, again.head).slower < rules.again &&
         is_slower(compared(together(first.base, again.base), together(first.head, again.head)), rules,
                   allowed);
}

std::vector<double> of_usual_layouts(const std::vector<double>& samples, const std::vector<int>& layouts) {
  std::map<int, std::vector<double>> by_layout;
  for (std::size_t i = 0; i < samples.size(); ++i) by_layout[layouts[i]].push_back(samples[i]);
  std::map<int, double> medians;
  std::vector<double> all;
  for (const auto& [layout, mine] : by_layout) all.push_back(medians[layout] = statistics::median(mine));
  const double most = (1 + kApart) * statistics::median(all);
  std::vector<double> out;
  for (std::size_t i = 0; i < samples.size(); ++i)
    if (!(medians[layouts[i]] > most)) out.push_back(samples[i]);  // a time that is missing, NaN, stays
  return out;
}

Table measure_round(Journal& journal, const Side& base, const Side& head, const BenchOptions& options,
                    int run, int round, int pairs, const std::filesystem::path& folder, const Told& told) {
  Table table;
  std::map<std::string, Layouts> layouts;
  const auto begin = Clock::now();
  int fresh = 0;
  for (int i = 0; i < 2 * pairs; ++i) {
    // A B, B A, A B: what drifts adds to both. The other way round in the next run.
    const int pair = i / 2;
    const bool is_head = (i + pair + run) % 2 == 1;
    const Turn turn{run, round, pair, is_head};
    const Side& side = is_head ? head : base;
    const int layout = layout_of(side, pair, is_head);
    const Reading* reading = journal.find(turn);
    if (reading == nullptr) {
      told(i, 2 * pairs, time_left(begin, fresh, 2 * pairs - i));
      BenchOptions mine = options;
      if (!is_head && options.slower > 0) mine.slower = 0;  // by the same road
      reading = &journal.add(turn, measure(side.programs[std::size_t(layout)], mine, folder));
      ++fresh;
    }
    include(table, layouts, *reading, is_head, layout);
  }
  told(2 * pairs, 2 * pairs, "");
  for (auto& [name, s] : table) {
    s.base = of_usual_layouts(s.base, layouts[name].base);
    s.head = of_usual_layouts(s.head, layouts[name].head);
  }
  return table;
}

Measured measure_times(Journal& journal, const Side& base, const Side& head, const BenchOptions& options,
                       const TimeRules& rules, int run, const std::filesystem::path& folder,
                       const Told& told) {
  Measured out;
  out.first = measure_round(journal, base, head, options, run, 0, rules.pairs, folder, told);
  std::vector<std::string> alarmed;
  for (const auto& [name, s] : out.first)
    if (is_slower(compared(s.base, s.head), rules, rules.allowed_of(name))) alarmed.push_back(name);
  if (alarmed.empty()) return out;
  BenchOptions few = options;
  few.filter = filter_of(alarmed);
  out.again = measure_round(journal, base, head, few, run, 1, rules.pairs, folder, told);
  return out;
}

}  // namespace halfway::gate
