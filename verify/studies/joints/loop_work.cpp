// Work round a generic closed loop (C9): none for a potential, else a power of the amplitude.
#include "verify/oracle/property.hpp"

namespace halfway::verify {
namespace {

constexpr double kAmplitude = 0.4;

JointSpec generic_spec(const Entry& entry, Kind kind) { return probes(entry, kind, 1, 0.8).front().spec; }

Finding relative_work(const Entry& entry, Kind kind, Finding f) {
  const Measurement work{loop_work(of(entry), generic_spec(entry, kind), kAmplitude).relative(),
                         "loop amplitude 0.4"};
  hold(f, work, entry.facts.loop_work.of(kind));
  f.unit = "relative to the turnover";
  if (f.comparison == Comparison::at_most) {
    f.high = 1e-15;
    f.reason = "100 points of the trapezoidal rule leave less than 1e-15 of the turnover at this amplitude";
  }
  return f;
}

Finding slope(const Entry& entry, Kind kind, Finding f) {
  if (entry.facts.loop_work.of(kind).holds()) {
    f.verdict = Verdict::left_out;
    f.reason = "no net work, hence no order in the amplitude";
    return f;
  }
  f.value = loop_slope(of(entry), generic_spec(entry, kind), 0.05);
  f.unit = "order in the amplitude";
  f.comparison = Comparison::equal;
  f.expected = entry.facts.loop_slope;
  f.high = 0.15;
  f.reason = "the next power of the amplitude, 0.05, against the leading one";
  return f;
}

}  // namespace

void loop_work(Checks& checks) {
  add_property(checks, "loop_work", {Kind::angular, Kind::linear, Kind::linear_angular}, relative_work);
  add_property(checks, "loop_slope", {Kind::angular}, slope);
}

}  // namespace halfway::verify
