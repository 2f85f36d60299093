// A rigid motion of both nodes turns the loads and does nothing else.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void objectivity(Checks& checks) {
  add_property(checks, "objectivity", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 return hold(f, objectivity(under_test(entry), probes(entry, kind, 8, 3.0)), {},
                             Oracle::closed_form);
               });
}

}  // namespace halfway::verify
