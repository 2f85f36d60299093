#include "reference/numbers/units.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <tuple>

namespace halfway::reference {
namespace {

constexpr std::size_t kLongest = 100;  // bytes of a unit: brackets inside brackets have an end
constexpr int kHighestPower = 9;

constexpr Dimension kForce{1, 0, 0}, kLength{0, 1, 0}, kAngle{0, 0, 1}, kMoment{1, 1, 0}, kPressure{1, -2, 0};
constexpr Dimension kTime{0, 0, 0, false, 1}, kMass = kForce * kTime * kTime / kLength;

struct Named {
  std::string_view name;
  const char* factor;  ///< decimal
  Dimension dimension;
  bool in_pi = false;  ///< times pi/180
};

// Inch, foot, pound (avoirdupois) and gravity are exact by definition: 0.0254 m, 0.45359237 kg, 9.80665
// m/s^2.
constexpr Named kUnits[] = {{"m", "1", kLength},
                            {"cm", "1e-2", kLength},
                            {"mm", "1e-3", kLength},
                            {"um", "1e-6", kLength},
                            {"km", "1e3", kLength},
                            {"in", "0.0254", kLength},
                            {"ft", "0.3048", kLength},
                            {"rad", "1", kAngle},
                            {"mrad", "1e-3", kAngle},
                            {"urad", "1e-6", kAngle},
                            {"deg", "1", kAngle, true},
                            {"rev", "360", kAngle, true},
                            {"N", "1", kForce},
                            {"mN", "1e-3", kForce},
                            {"daN", "10", kForce},
                            {"kN", "1e3", kForce},
                            {"MN", "1e6", kForce},
                            {"GN", "1e9", kForce},
                            {"lbf", "4.4482216152605", kForce},
                            {"kip", "4448.2216152605", kForce},
                            {"kgf", "9.80665", kForce},
                            {"Nm", "1", kMoment},
                            {"Nmm", "1e-3", kMoment},
                            {"kNm", "1e3", kMoment},
                            {"Pa", "1", kPressure},
                            {"kPa", "1e3", kPressure},
                            {"MPa", "1e6", kPressure},
                            {"GPa", "1e9", kPressure},
                            {"s", "1", kTime},
                            {"ms", "1e-3", kTime},
                            {"us", "1e-6", kTime},
                            {"min", "60", kTime},
                            {"kg", "1", kMass},
                            {"g", "1e-3", kMass},
                            {"t", "1e3", kMass},
                            {"lb", "0.45359237", kMass}};

Unit of(const Named& unit) {
  Unit out{Real50(unit.factor), unit.dimension};
  if (unit.in_pi) out.factor = out.factor * pi50() / Real50(180);
  return out;
}

/// Brackets in brackets may ask for any power.
Unit product_of(const Unit& a, const Unit& b, bool divides) {
  const Unit out = divides ? Unit{a.factor / b.factor, a.dimension / b.dimension}
                           : Unit{a.factor * b.factor, a.dimension * b.dimension};
  for (const int power :
       {out.dimension.force, out.dimension.length, out.dimension.angle, out.dimension.time}) {
    if (std::abs(power) > kHighestPower)
      throw NoUnit(fmt::format("has a power beyond {}", kHighestPower), "");
  }
  return out;
}

Unit power(const Unit& unit, int exponent) {
  Unit out;
  for (int i = 0; i < std::abs(exponent); ++i) out = product_of(out, unit, exponent < 0);
  return out;
}

/// By recursive descent.
class UnitText {
 public:
  explicit UnitText(std::string_view text) : whole_(text), rest_(text) {}

  Unit all() {
    if (whole_.size() > kLongest) fail("is too long");
    const Unit out = product();
    if (!rest_.empty()) fail(fmt::format("has '{}' where it should end", rest_.substr(0, 1)));
    return out;
  }

 private:
  Unit product() {
    Unit out = factor();
    for (;;) {
      const bool divides = takes("/");
      if (!divides && !takes("*") && !takes("·") && !begins_factor()) return out;
      out = product_of(out, factor(), divides);
    }
  }

  Unit factor() {
    Unit out;
    if (takes("(")) {
      out = product();
      if (!takes(")")) fail("has a bracket that is not closed");
    } else if (!takes("1")) {
      out = named();
    }
    return takes("^") ? power(out, exponent()) : out;
  }

  Unit named() {
    if (takes("°")) return read_unit("deg");
    const auto end = std::ranges::find_if_not(rest_, is_letter);
    const std::string_view name = rest_.substr(0, std::size_t(end - rest_.begin()));
    if (name.empty()) fail("lacks a unit");
    const auto found = std::ranges::find(kUnits, name, &Named::name);
    if (found == std::end(kUnits))
      throw NoUnit(fmt::format("has '{}', which is no unit that is known", name), std::string(name));
    rest_.remove_prefix(name.size());
    return of(*found);
  }

  int exponent() {
    skip();
    int out = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), out);
    if (error != std::errc{} || std::abs(out) > kHighestPower)
      fail(fmt::format("has a power that is no integer up to {}", kHighestPower));
    rest_.remove_prefix(std::size_t(end - rest_.data()));
    return out;
  }

  static bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
  bool begins_factor() {
    skip();
    return !rest_.empty() && (is_letter(rest_.front()) || rest_.front() == '(' || rest_.starts_with("°"));
  }
  void skip() { rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size())); }
  bool takes(std::string_view sign) {
    skip();
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }
  [[noreturn]] void fail(const std::string& what) const { throw NoUnit(what, ""); }

  std::string_view whole_, rest_;
};

/// "m^2", "rad"; "" of the power 0.
std::string powered(std::string_view name, int power) {
  if (power == 0) return "";
  return power == 1 ? std::string(name) : fmt::format("{}^{}", name, power);
}

/// "N m^2" of what has positive powers, where `sign` is 1.
std::string product_text(const Dimension& d, int sign) {
  std::string out;
  // A mass or an inertia has the time of a force and no other: then kg, as people write it.
  const bool in_kg = d.time != 0 && d.time == 2 * d.force;
  const int length = in_kg ? d.length + d.force : d.length, time = in_kg ? 0 : d.time;
  for (const auto& [name, power] :
       {std::pair{in_kg ? "kg" : "N", d.force}, {"m", length}, {"s", time}, {"rad", d.angle}}) {
    const std::string one = powered(name, std::max(0, sign * power));
    out += (out.empty() || one.empty() ? "" : " ") + one;
  }
  return out;
}

}  // namespace

bool fits(const Dimension& found, const Dimension& needed) {
  return found.force == needed.force && found.length == needed.length && found.time == needed.time &&
         (found.angle == needed.angle || (needed.is_angle_free && found.angle == 0));
}

std::string si_unit(const Dimension& dimension) {
  const std::string above = product_text(dimension, 1), below = product_text(dimension, -1);
  const std::string top = above.empty() ? "1" : above;
  if (below.empty()) return top;
  return below.find(' ') == std::string::npos ? fmt::format("{}/{}", top, below)
                                              : fmt::format("{}/({})", top, below);
}

std::string example_units(const Dimension& d) {
  struct Examples {
    Dimension dimension;
    const char* units;
  };
  static constexpr Examples kExamples[] = {{kLength, "mm, in"},
                                           {kAngle, "deg, mrad"},
                                           {kForce, "kN, lbf"},
                                           {kMoment, "kN m, N mm, lbf in"},
                                           {kForce / kLength, "N/mm, kN/m, lbf/in"},
                                           {kMoment / kAngle, "N m/deg, kN mm/rad, lbf in/deg"},
                                           {kForce / kAngle, "kN, N/deg, N mm/mm"},
                                           {kAngle / kForce, "1/kN, deg/N, mm/(N m)"},
                                           {kLength / kForce, "mm/N, um/kN"},
                                           {kAngle / kMoment, "deg/(N m), mrad/(kN m)"},
                                           {kTime, "ms, min"},
                                           {kMass, "g, t, lb, lbf s^2/in"},
                                           {kMass * kLength * kLength, "kg mm^2, lb in^2"},
                                           {kLength / kTime, "mm/s, in/s"},
                                           {kAngle / kTime, "deg/s, rev/min"},
                                           {kForce * kTime / kLength, "N s/mm, kg/s, lbf s/in"},
                                           {kMoment * kTime / kAngle, "N m s/deg, N mm s/rad"}};
  for (const Examples& e : kExamples) {
    const Dimension& known = e.dimension;
    if (std::tie(known.force, known.length, known.angle, known.time) ==
        std::tie(d.force, d.length, d.angle, d.time))
      return fmt::format("{}, {}", si_unit(d), e.units);
  }
  return si_unit(d);
}

Unit read_unit(std::string_view text) { return UnitText(text).all(); }

const std::vector<std::string_view>& unit_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> out;
    for (const Named& unit : kUnits) out.push_back(unit.name);
    return out;
  }();
  return names;
}

QuantityText split_quantity(std::string_view text) {
  const auto trimmed = [](std::string_view t) {
    t.remove_prefix(std::min(t.find_first_not_of(' '), t.size()));
    return t.substr(0, t.find_last_not_of(' ') + 1);
  };
  const std::string_view whole = trimmed(text);
  const std::size_t sign = whole.starts_with('+') || whole.starts_with('-') ? 1 : 0;
  const bool has_digit =
      whole.size() > sign && (std::string_view("0123456789.").find(whole[sign]) != std::string_view::npos);
  if (!has_digit) return {{}, whole};
  const std::size_t start = whole.starts_with('+') ? 1 : 0;
  double ignored = 0;
  const auto [end, error] = std::from_chars(whole.data() + start, whole.data() + whole.size(), ignored);
  const auto length = std::size_t(end - whole.data());
  if (error == std::errc::invalid_argument) return {{}, whole};
  return {whole.substr(start, length - start), trimmed(whole.substr(length))};
}

double in_si(std::string_view decimal, const Unit& unit) {
  return double(Real50(std::string(decimal).c_str()) * unit.factor);
}

}  // namespace halfway::reference
