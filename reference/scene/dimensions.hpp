// The dimensions of a joint's numbers, translations before rotations.
#pragma once

#include "halfway/joint/pose.hpp"
#include "reference/numbers/units.hpp"

namespace halfway::reference {

namespace dimension {
inline constexpr Dimension none{}, force{1, 0, 0}, length{0, 1, 0}, angle{0, 0, 1}, moment{1, 1, 0};
}  // namespace dimension

/// Of a list: its first three entries and those that follow, where they differ.
struct Dimensions {
  constexpr Dimensions() = default;
  constexpr Dimensions(const Dimension& all) : head(all), tail(all) {}
  constexpr Dimensions(const Dimension& first, const Dimension& rest) : head(first), tail(rest) {}
  constexpr const Dimension& operator[](int i) const { return i < 3 ? head : tail; }
  constexpr bool operator==(const Dimensions&) const = default;

  Dimension head{}, tail{};
};

/// Of a matrix, by rows.
struct MatrixDimensions {
  constexpr const Dimensions& operator[](int i) const { return i < 3 ? head : tail; }
  constexpr bool operator==(const MatrixDimensions&) const = default;

  Dimensions head{}, tail{};
};

constexpr Dimensions strain_dimensions(Kind kind) {
  if (kind == Kind::linear_angular) return {dimension::length, dimension::angle};
  return kind == Kind::linear ? dimension::length : dimension::angle;
}

constexpr Dimensions stress_dimensions(Kind kind) {
  if (kind == Kind::linear_angular) return {dimension::force, dimension::moment};
  return kind == Kind::linear ? dimension::force : dimension::moment;
}

/// Of the matrix that makes `of` from `by`; where it couples translations with rotations rad may be left out.
constexpr MatrixDimensions ratio(const Dimensions& of, const Dimensions& by) {
  const auto entry = [](const Dimension& a, const Dimension& b, bool couples) {
    Dimension out = a / b;
    out.is_angle_free = couples;
    return out;
  };
  return {{entry(of.head, by.head, false), entry(of.head, by.tail, true)},
          {entry(of.tail, by.head, true), entry(of.tail, by.tail, false)}};
}

/// Of a over the power of b, entry by entry.
constexpr Dimensions over_power(const Dimensions& a, const Dimensions& b, int power) {
  Dimensions out = a;
  for (int i = 0; i < power; ++i) out = {out.head / b.head, out.tail / b.tail};
  return out;
}

constexpr Dimensions diagonal(const MatrixDimensions& m) { return {m.head.head, m.tail.tail}; }

}  // namespace halfway::reference
