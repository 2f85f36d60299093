// The loads are the gradient of the law's energy, by dual numbers, where there is a potential.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void energy_gradient(Checks& checks) {
  add_property(checks, "energy_gradient", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Finding f) {
                 if (!entry.has_potential(kind)) {
                   f.verdict = Verdict::left_out;
                   f.reason = "this formulation has no potential of this kind; see symmetry and loop_work";
                   return f;
                 }
                 hold(f, energy_gradient(of(entry), probes(entry, kind, 8, 3.0)), {});
                 return f;
               });
}

}  // namespace halfway::verify
