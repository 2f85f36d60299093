// Work round a closed loop over the amplitude: the order of the leak, for every kind of joint.
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

constexpr double kSmall = 1e-5;  ///< amplitude, rad and m

/// The net work of an analytic field round a loop is a power series in the amplitude: its order is a whole
/// number, which the header declares.
Finding order(const Entry& entry, Kind kind, Finding f) {
  const JointSpec spec = probes(entry, kind, 1, 0.8).front().spec;
  const LoopWork small = loop_work(of(entry), spec, kSmall);
  f.parameter = fmt::format("amplitudes {:.3g} and {:.3g}", kSmall, 2 * kSmall);
  if (entry.facts.loop_work.of(kind).holds()) {
    f.value = small.relative();
    f.unit = "relative to the turnover";
    f.comparison = Comparison::at_most;
    f.high = kRounding;
    f.reason = kRoundingReason;
    return f;
  }
  const LoopWork twice = loop_work(of(entry), spec, 2 * kSmall);
  f.value = std::log2(std::abs(double(twice.net / small.net)));
  f.unit = "order in the amplitude";
  f.comparison = Comparison::equal;
  f.oracle = Oracle::independent;
  f.expected = entry.facts.loop_slope;
  f.high = 100 * kSmall;
  f.reason =
      "a whole number, for the work is a power series in the amplitude; the next power adds up to 80 times "
      "the amplitude";
  return f;
}

}  // namespace

void energy_loops(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      const Finding named = property_finding(entry, kind, "loop_order");
      checks.push_back({named.name, "stability", [&entry, kind, named] {
                          return std::vector<Finding>{judged(order(entry, kind, named))};
                        }});
    }
  }
}

}  // namespace halfway::verify
