// Numbers with a unit, as people write them: "1.8 N m/deg", "12 mm", "3 kN/mm".
#pragma once

#include "reference/numbers/precision.hpp"

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace halfway::reference {

/// Powers of N, m, rad and s: all that a joint, a chain, their loads and their motion are given in; 1 kg is
/// 1 N s^2/m.
struct Dimension {
  int force = 0, length = 0, angle = 0;
  bool is_angle_free = false;  ///< rad may be left out: N/rad and N m/m are one coupling
  int time = 0;

  constexpr bool operator==(const Dimension&) const = default;
  friend constexpr Dimension operator*(const Dimension& a, const Dimension& b) {
    return {a.force + b.force, a.length + b.length, a.angle + b.angle, a.is_angle_free || b.is_angle_free,
            a.time + b.time};
  }
  friend constexpr Dimension operator/(const Dimension& a, const Dimension& b) {
    return {a.force - b.force, a.length - b.length, a.angle - b.angle, a.is_angle_free || b.is_angle_free,
            a.time - b.time};
  }
};

/// May a value of the dimension `found` stand where `needed` is?
bool fits(const Dimension& found, const Dimension& needed);

/// "N m/rad"; "1" of a plain number.
std::string si_unit(const Dimension& dimension);

/// Units of that dimension as examples: "N m/deg, kN mm/rad".
std::string example_units(const Dimension& dimension);

/// What a unit is in SI, all 50 digits: 1 deg = pi/180 rad.
struct Unit {
  Real50 factor{1};
  Dimension dimension{};
};

/// A unit of a text that is none. `name`: the one that is not known, or empty where the text is no unit.
struct NoUnit : std::invalid_argument {
  NoUnit(const std::string& what, std::string name_) : invalid_argument(what), name(std::move(name_)) {}
  std::string name;
};

/// "N m/deg", "kN*mm", "deg/(N m)", "N/mm^3": products of units by a space, * or ·, quotients by /, which
/// divides by the one unit behind it, whole powers by ^. Throws NoUnit.
Unit read_unit(std::string_view text);

/// The units that read_unit knows.
const std::vector<std::string_view>& unit_names();

/// A text such as "-1.5e3 mm" as its number and its unit, either of which may be empty.
struct QuantityText {
  std::string_view number, unit;
};
QuantityText split_quantity(std::string_view text);

/// A decimal in a unit as the double next to its value in SI.
double in_si(std::string_view decimal, const Unit& unit);

}  // namespace halfway::reference
