// Wrong twins of a formulation, made by wrapping it at the run-time face: same name, references and closed
// forms, in double, 50 digits and duals alike, and no template is built for them.
#pragma once

#include "reference/face/registry.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::verify {

/// What of a formulation a check asks for, or a saboteur spoils.
struct Parts {
  bool moments = false, forces = false, tangent = false, strain = false, energy = false;
  bool taps = false;  ///< what is no formulation's, see tap.hpp
  bool any() const { return moments || forces || tangent || strain || energy || taps; }
};

struct Saboteur {
  std::string_view name;
  std::string_view does;
  Parts nan;  ///< what it makes NaN: whoever sees that part has to fail
  reference::Entry (*of)(const reference::Entry& healthy);
  Tap tap = Tap::healthy;
};

/// In the order in which checks meet them: those that make something NaN first; no loads last, as 0/0 is NaN
/// too.
std::span<const Saboteur> saboteurs();

/// nullptr where there is none of that name.
const Saboteur* find_saboteur(std::string_view name);

/// The saboteur in the place of one formulation, or, without a name, of each of them; while it lives.
class ScopedSabotage {
 public:
  explicit ScopedSabotage(const Saboteur& saboteur, std::string_view formulation = {});

 private:
  reference::ScopedRegistry registry_;
  ScopedTap tap_;
};

/// The catalog as it is behind a wrapper that changes nothing and notes in `seen` (which must outlive it)
/// what is asked for.
std::vector<reference::Entry> witnessed(Parts& seen);

}  // namespace halfway::verify
