#include "reports/advise/cost/cost.hpp"

#include "bench/harness/case.hpp"
#include "bench/harness/flops.hpp"
#include "reference/face/registry.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <set>

namespace halfway::bench {
Cases kernel_cases();
Cases kernel_variant_cases();
}  // namespace halfway::bench

namespace halfway::advise {
namespace {

constexpr int kRounds = 9;        // of all in turn, so that what a busy machine does meets them alike
constexpr double kRound = 2.5e5;  // ns of each in a round, a thousand times the clock's own

/// Something to be timed: so many evaluations in one call.
struct Timed {
  std::string name;
  std::function<void(int)> evaluate;
  int evaluations = 1;
  int calls = 1;
  std::vector<double> ns{};
};

double time_of(const Timed& timed, int calls) {
  const double begin = thread_ns();
  timed.evaluate(calls);
  return thread_ns() - begin;
}

/// In rounds, all in turn.
void time_all(std::vector<Timed>& all) {
  for (Timed& timed : all) {
    const double once = std::max(time_of(timed, 1), 1.);  // and its data are in the cache
    timed.calls = std::max(1, int(kRound / once));
  }
  for (int round = 0; round < kRounds; ++round)
    for (Timed& timed : all)
      timed.ns.push_back(time_of(timed, timed.calls) / timed.calls / timed.evaluations);
}

}  // namespace

double thread_ns() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e9 * double(now.tv_sec) + double(now.tv_nsec);
}

Cost of_rounds(std::vector<double> ns) {
  std::ranges::sort(ns);
  const auto quarter = [&](std::size_t i) { return ns[i * (ns.size() - 1) / 4]; };
  return {quarter(2), (quarter(3) - quarter(1)) / 2 / quarter(2)};
}

std::map<std::string, Cost> kernel_costs(const std::vector<Candidate>& candidates) {
  std::set<std::string> wanted;
  for (const Candidate& c : candidates) wanted.insert(c.timing());
  std::map<std::string, Cost> out;
  std::vector<Timed> timed;
  bench::Cases cases = bench::kernel_cases();
  std::ranges::move(bench::kernel_variant_cases(), std::back_inserter(cases));
  for (const bench::Case& c : cases) {
    if (!wanted.contains(c.name) || !c.evaluate) continue;
    const bench::Checked& check = bench::checked(c);
    if (!check.message.empty()) continue;  // wrong: what it takes is of no interest
    timed.push_back({c.name, c.evaluate, c.evaluations});
    out[c.name] = {.error = check.error, .flops = c.flops};
  }
  time_all(timed);
  for (const Timed& t : timed) {
    const Cost cost = of_rounds(t.ns);
    out[t.name].ns = cost.ns, out[t.name].spread = cost.spread;
  }
  for (const Candidate& c : candidates)
    if (!c.entry) out[c.timing()] = linear_cost(c.kind);
  return out;
}

std::map<std::string, Cost> counted_costs(const std::vector<Candidate>& candidates) {
  std::map<std::string, Cost> out;
  for (const Candidate& c : candidates) {
    const double flops = c.entry ? bench::kept_flops(c.timing()) : c.kind == Kind::angular ? 33 : 276;
    if (flops > 0) out[c.timing()] = {.ns = flops, .flops = flops};
  }
  return out;
}

std::map<std::string, Cost> face_costs(const reference::Scene& scene,
                                       const std::vector<Candidate>& candidates) {
  std::map<std::string, Cost> out;
  std::vector<Timed> timed;
  for (const Candidate& c : candidates) {
    if (!c.entry) continue;
    reference::JointSpec spec = scene.joint;
    spec.xi = c.xi;
    const Pose<double> rest = reference::rest_pose(scene);
    timed.push_back({c.timing(), [spec, rest, entry = c.entry](int calls) {
                       for (int i = 0; i < calls; ++i) {
                         const auto loads = reference::node_loads<double>(*entry, spec, {}, rest, true);
                         asm volatile("" : : "g"(&loads) : "memory");
                       }
                     }});
  }
  time_all(timed);
  for (const Timed& t : timed) out[t.name] = of_rounds(t.ns);
  for (const Candidate& c : candidates)
    if (!c.entry) out[c.timing()] = linear_cost(c.kind);
  return out;
}

}  // namespace halfway::advise
