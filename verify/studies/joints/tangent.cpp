// The analytic tangent is the derivative of the loads, by dual numbers.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void tangent(Checks& checks) {
  add_property(checks, "tangent", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 return hold(f, tangent_by_duals(under_test(entry), probes(entry, kind, 8, 3.0)), {},
                             Oracle::independent);
               });
}

}  // namespace halfway::verify
