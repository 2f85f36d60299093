// The forces on the two nodes sum to zero.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void force_balance(Checks& checks) {
  add_property(checks, "force_balance", {Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Finding f) {
                 hold(f, force_balance(of(entry), probes(entry, kind, 8, 3.0)), {});
                 return f;
               });
}

}  // namespace halfway::verify
