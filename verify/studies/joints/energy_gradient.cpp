// The loads are the gradient of the law's energy, by dual numbers, where there is a potential.
#include "verify/oracle/property.hpp"

namespace halfway::verify {

void energy_gradient(Checks& checks) {
  add_property(
      checks, "energy_gradient", {Kind::angular, Kind::linear, Kind::linear_angular},
      [](const Entry& entry, Kind kind, Draft f) {
        if (!entry.has_potential(kind))
          return f.left_out("this formulation has no potential of this kind; see symmetry and loop_work");
        return hold(f, energy_gradient(under_test(entry), probes(entry, kind, 8, 3.0)), {},
                    Oracle::independent);
      });
}

}  // namespace halfway::verify
