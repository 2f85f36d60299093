// Work round a closed loop over the amplitude: the order of the leak, for every kind of joint.
#include "verify/once.hpp"
#include "verify/oracle/property.hpp"
#include "verify/studies/motion/energy.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::verify {
namespace {

JointSpec loop_joint(const Entry& entry, Kind kind) { return probes(entry, kind, 1, 0.8).front().spec; }

JointUnderTest in_double(const Entry& entry) {
  JointUnderTest out;
  out.loads = [&entry](const auto& spec, const auto& a, const auto& b, bool with_tangent) {
    NodeLoads<Real50> loads;
    loads.q =
        node_loads<double>(entry, spec, reference::cast<double>(a), reference::cast<double>(b), with_tangent)
            .q.template cast<Real50>();
    return loads;
  };
  return out;
}

/// The net work of an analytic field round a loop is a power series in the amplitude: its order is a whole
/// number, which the header declares.
Finding order(const Entry& entry, Kind kind, Draft f) {
  const SmallLoops& loops = small_loops(entry, kind);
  const std::string where = fmt::format("amplitudes {:.3g} and {:.3g}", kSmallAmplitude, 2 * kSmallAmplitude);
  f.by(Oracle::closed_form);
  if (entry.facts.loop_work.of(kind).holds())
    return f.measured(loops.once.relative(), where)
        .in("relative to the turnover")
        .at_most(kRounding, kRoundingReason);
  return f.measured(loops.order(), where)
      .in("order in the amplitude")
      .equal(entry.facts.loop_slope, 100 * kSmallAmplitude,
             "a whole number, for the work is a power series in the amplitude; the next power adds up to 80 "
             "times "
             "the amplitude");
}

}  // namespace

double SmallLoops::order() const { return std::log2(std::abs(double(twice.net / once.net))); }

const SmallLoops& small_loops(const Entry& entry, Kind kind) {
  static Once<SmallLoops, Kind> known;
  return known(entry, kind, [&] {
    const JointSpec spec = loop_joint(entry, kind);
    return SmallLoops{loop_work(under_test(entry), spec, kSmallAmplitude),
                      loop_work(under_test(entry), spec, 2 * kSmallAmplitude)};
  });
}

std::vector<WideLoop> wide_loops(const Entry& entry, Kind kind) {
  const auto joint = in_double(entry);
  const JointSpec spec = loop_joint(entry, kind);
  std::vector<WideLoop> out;
  for (double amplitude = 0.0125; amplitude < 1; amplitude *= 2) {
    const int count = amplitude < 0.2 ? 40 : 100;  // rounding is left, but at the widest loops
    out.push_back({amplitude, loop_work(joint, spec, amplitude, count).relative()});
  }
  return out;
}

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
