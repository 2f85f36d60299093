#include "verify/oracle/saboteurs/claims.hpp"

#include <algorithm>
#include <iterator>

namespace halfway::verify {
namespace {

struct Overlooks {
  std::string_view ending;  ///< of the check's name
  Parts parts;
  std::string_view why;
};

constexpr Overlooks kOverlooked[] = {
    {"/force_balance", {.moments = true}, "adds the forces alone"},
    {"/symmetry", {.forces = true}, "the commutator of the spins is of the moments"},
    {"/linear/modelling_error", {.forces = true}, "judges the moment of a node whose orientation is held"},
    {"/rounding_tangent", {.moments = true, .forces = true}, "compares tangents; /rounding has the loads"},
};

}  // namespace

Parts overlooked(const std::string& check) {
  const auto it =
      std::ranges::find_if(kOverlooked, [&](const Overlooks& o) { return check.ends_with(o.ending); });
  return it == std::end(kOverlooked) ? Parts{} : it->parts;
}

}  // namespace halfway::verify
