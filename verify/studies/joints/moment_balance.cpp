// The moments of the loads on the two nodes, about one point, sum to zero. Not of angular joints: the library
// returns the moment on one node alone.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void moment_balance(Checks& checks) {
  add_property(checks, "moment_balance", {Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 return hold(f, moment_balance(under_test(entry), probes(entry, kind, 8, 0.8)),
                             entry.facts.moment_balance.of(kind), Oracle::closed_form);
               });
}

}  // namespace halfway::verify
