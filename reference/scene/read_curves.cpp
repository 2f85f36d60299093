#include "reference/scene/read_curves.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <memory>

namespace halfway::reference {
namespace {

const Names kAxisKeys = {"stiffness", "k1", "k3", "k5", "x", "y", "interpolation", "negative", "positive"};

constexpr const char* kOneLaw = "stiffness; k1, k3, k5; x, y, interpolation; or negative, positive";

/// What the numbers of one strain are in.
struct AxisUnits {
  Dimension strain, stress;
  Dimension over(int power) const {
    Dimension out = stress;
    for (int i = 0; i < power; ++i) out = out / strain;
    return out;
  }
};

double slope_at_rest(const Field& field, const AxisUnits& units) {
  const double slope = field.number(units.over(1));
  if (slope < 0) field.refuse("is negative, but is a slope at rest", "a number >= 0", "indefinite_stiffness");
  return slope;
}

PiecewisePolynomial polynomial(const Field& axis, const AxisUnits& units, const char* first) {
  PiecewisePolynomial out;
  auto& c = out.pieces.front();
  c[1] = slope_at_rest(axis.at(first, "a number >= 0"), units);
  if (const auto k3 = axis.find("k3")) c[3] = k3->number(units.over(3));
  if (const auto k5 = axis.find("k5")) c[5] = k5->number(units.over(5));
  return out;
}

PiecewisePolynomial bilinear(const Field& axis, const AxisUnits& units) {
  const std::string allowed = "the slopes below and above zero strain, numbers >= 0";
  PiecewisePolynomial out;
  out.knots = {0};
  out.pieces = {{0, slope_at_rest(axis.at("negative", allowed), units)},
                {0, slope_at_rest(axis.at("positive", allowed), units)}};
  return out;
}

Interpolation read_interpolation(const Field& axis) {
  const auto field = axis.find("interpolation");
  const std::string name = field ? field->one_of({"linear", "akima", "monotone"}) : "linear";
  return name == "akima"      ? Interpolation::akima
         : name == "monotone" ? Interpolation::monotone
                              : Interpolation::linear;
}

void check_increasing(const Field& field, const std::vector<double>& x) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!(x[i] > x[i - 1]))
      field.refuse(fmt::format("does not increase: {:g} comes behind {:g}", x[i], x[i - 1]),
                   "strains that strictly increase");
  }
}

/// A strain and a stress may each be finite and their slope or a coefficient not.
bool is_finite(const PiecewisePolynomial& curve) {
  for (const auto& piece : curve.pieces) {
    for (const double c : piece) {
      if (!std::isfinite(c)) return false;
    }
  }
  return true;
}

void check_rising_at_rest(const Field& y, const PiecewisePolynomial& curve) {
  const double below = curve.at(-std::numeric_limits<double>::denorm_min()).slope,
               above = curve.at(0.0).slope;
  if (!(below >= 0 && above >= 0))
    y.refuse(fmt::format("falls at rest: its slope at zero strain is {:.4g}", below < 0 ? below : above),
             "a slope >= 0 at zero strain", "indefinite_stiffness");
}

PiecewisePolynomial table(const Field& axis, const AxisUnits& units) {
  const Field x_field = axis.at("x", "strains that strictly increase");
  const Field y_field = axis.at("y", "a stress for each x");
  const auto x = x_field.numbers("an array of strains", units.strain);
  const auto y = y_field.numbers("an array of stresses", units.stress);
  if (x.size() != y.size())
    y_field.refuse(fmt::format("has {} entries, x has {}", y.size(), x.size()), "a stress for each x",
                   "wrong_shape");
  const Interpolation method = read_interpolation(axis);
  if (x.size() < fewest_points(method))
    x_field.refuse(fmt::format("has {} points", x.size()),
                   fmt::format("at least {} for this interpolation", fewest_points(method)), "wrong_shape");
  check_increasing(x_field, x);
  PiecewisePolynomial out = interpolated(x, y, method);
  if (!is_finite(out))
    x_field.refuse("has points whose slope is not finite", "points farther apart, or smaller stresses");
  check_rising_at_rest(y_field, out);
  return out;
}

/// The first of the axis's keys that each sort of law has.
std::optional<Field> first_of(const Field& axis, std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys) {
    if (const auto field = axis.find(key)) return field;
  }
  return std::nullopt;
}

PiecewisePolynomial read_axis(const Field& axis, const AxisUnits& units) {
  axis.has_only(kAxisKeys);
  const std::optional<Field> sorts[] = {first_of(axis, {"stiffness"}), first_of(axis, {"k1", "k3", "k5"}),
                                        first_of(axis, {"x", "y", "interpolation"}),
                                        first_of(axis, {"negative", "positive"})};
  int found = -1;
  for (int i = 0; i < 4; ++i) {
    if (!sorts[i]) continue;
    if (found >= 0)
      sorts[i]->refuse("stands beside another law of the axis", std::string("one of ") + kOneLaw,
                       "named_twice");
    found = i;
  }
  switch (found) {
    case 0:
      return polynomial(axis, units, "stiffness");
    case 1:
      return polynomial(axis, units, "k1");
    case 2:
      return table(axis, units);
    case 3:
      return bilinear(axis, units);
    default:
      axis.refuse("says no law", kOneLaw, "missing_key");
  }
}

}  // namespace

PerAxisSpec read_curves(const Field& law, Kind kind) {
  const int n = strain_count(kind);
  const std::string allowed = fmt::format("{} tables [[axis]], one for each strain, translation first", n);
  const Dimensions strain = strain_dimensions(kind), stress = stress_dimensions(kind);
  const Field axes = law.at("axis", allowed);
  const auto curves = std::make_shared<std::vector<PiecewisePolynomial>>();
  bool has_tables = false;
  for (const Field axis : axes.items(allowed)) {
    const int i = int(curves->size());
    if (i < n)
      curves->push_back(read_axis(axis, {strain[i], stress[i]}));
    else
      axes.refuse("has more tables than strains", allowed, "wrong_shape");
    has_tables |= axis.find("x").has_value();
  }
  if (int(curves->size()) != n)
    axes.refuse(fmt::format("has {} tables", curves->size()), allowed, "wrong_shape");
  if (has_tables) axes.note("has tables: beyond its ends a table goes straight on with the slope there");
  return {curves};
}

}  // namespace halfway::reference
