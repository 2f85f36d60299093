// The forces on the two nodes sum to zero.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void force_balance(Checks& checks) {
  add_property(checks, "force_balance", {Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 return hold(f, force_balance(under_test(entry), probes(entry, kind, 8, 3.0)), {},
                             Oracle::closed_form);
               });
}

}  // namespace halfway::verify
