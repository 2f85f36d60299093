// Work round a generic closed loop (C9): none for a potential, else a power of the amplitude (energy_loops).
#include "verify/oracle/property.hpp"

namespace halfway::verify {
namespace {

constexpr double kAmplitude = 0.4;

Finding relative_work(const Entry& entry, Kind kind, Draft f) {
  const JointSpec spec = probes(entry, kind, 1, 0.8).front().spec;
  const Measurement work{loop_work(under_test(entry), spec, kAmplitude).relative(), "loop amplitude 0.4"};
  const Band& band = entry.facts.loop_work.of(kind);
  f = hold(f, work, band, Oracle::closed_form).in("relative to the turnover");
  if (!band.holds()) return f;
  return f.at_most(
      1e-15, "100 points of the trapezoidal rule leave less than 1e-15 of the turnover at this amplitude");
}

}  // namespace

void loop_work(Checks& checks) {
  add_property(checks, "loop_work", {Kind::angular, Kind::linear, Kind::linear_angular}, relative_work);
}

}  // namespace halfway::verify
