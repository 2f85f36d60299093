// The tangent is symmetric but for the commutator of the spins: exactly so when there is a potential.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void symmetry(Checks& checks) {
  add_property(checks, "symmetry", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 return hold(f, symmetry_defect(under_test(entry), probes(entry, kind, 8, 0.8)),
                             entry.facts.symmetry.of(kind), Oracle::closed_form);
               });
}

}  // namespace halfway::verify
