// Work round a closed loop over the amplitude: the order of the leak, for every kind of joint.
#include "verify/oracle/property.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

constexpr double kSmall = 1e-5;  ///< amplitude, rad and m

/// The net work of an analytic field round a loop is a power series in the amplitude: its order is a whole
/// number, which the header declares.
Finding order(const Entry& entry, Kind kind, Draft f) {
  const JointSpec spec = probes(entry, kind, 1, 0.8).front().spec;
  const LoopWork small = loop_work(of(entry), spec, kSmall);
  const std::string where = fmt::format("amplitudes {:.3g} and {:.3g}", kSmall, 2 * kSmall);
  f.by(Oracle::closed_form);
  if (entry.facts.loop_work.of(kind).holds())
    return f.measured(small.relative(), where)
        .in("relative to the turnover")
        .at_most(kRounding, kRoundingReason);
  const LoopWork twice = loop_work(of(entry), spec, 2 * kSmall);
  return f.measured(std::log2(std::abs(double(twice.net / small.net))), where)
      .in("order in the amplitude")
      .equal(entry.facts.loop_slope, 100 * kSmall,
             "a whole number, for the work is a power series in the amplitude; the next power adds up to 80 "
             "times "
             "the amplitude");
}

}  // namespace

void energy_loops(Checks& checks) {
  for (const Entry& entry : reference::formulations()) {
    for (Kind kind : kKinds) {
      const char* what = "loop_order";
      checks.push_back({property_name(entry, kind, what), "stability", [&entry, kind, what] {
                          return std::vector{order(entry, kind, property_finding(entry, kind, what))};
                        }});
    }
  }
}

}  // namespace halfway::verify
