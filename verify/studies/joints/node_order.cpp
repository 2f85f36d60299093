// Listing the nodes in the other order changes nothing.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void node_order(Checks& checks) {
  add_property(checks, "node_order", {Kind::angular, Kind::linear, Kind::linear_angular},
               [](const Entry& entry, Kind kind, Draft f) {
                 return hold(f, node_swap(under_test(entry), probes(entry, kind, 8, 0.8)),
                             entry.facts.node_order.of(kind), Oracle::closed_form);
               });
}

}  // namespace halfway::verify
