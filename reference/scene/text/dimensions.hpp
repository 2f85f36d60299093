// The dimensions of a joint's numbers, translations before rotations.
#pragma once

#include "halfway/joint/pose.hpp"
#include "reference/numbers/units.hpp"

namespace halfway::reference {

namespace dimension {
inline constexpr Dimension none{}, force{1, 0, 0}, length{0, 1, 0}, angle{0, 0, 1}, moment{1, 1, 0};
inline constexpr Dimension time{0, 0, 0, false, 1}, mass = force * time * time / length,
                                                    inertia = mass * length * length;
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

/// Of the matrix that makes `of` from `by`. What couples translations with rotations is one quantity above
/// and below the diagonal, N/rad and N m/m: in both with rad or without.
constexpr MatrixDimensions ratio(const Dimensions& of, const Dimensions& by) {
  const Dimension above = of.head / by.tail, below = of.tail / by.head;
  Dimension couples = above.angle != 0 ? above : below;
  couples.is_angle_free = true;
  return {{of.head / by.head, couples}, {couples, of.tail / by.tail}};
}

/// Of a over the power of b, entry by entry.
constexpr Dimensions over_power(const Dimensions& a, const Dimensions& b, int power) {
  Dimensions out = a;
  for (int i = 0; i < power; ++i) out = {out.head / b.head, out.tail / b.tail};
  return out;
}

/// Of each entry times b.
constexpr MatrixDimensions times(const MatrixDimensions& m, const Dimension& b) {
  return {{m.head.head * b, m.head.tail * b}, {m.tail.head * b, m.tail.tail * b}};
}

constexpr Dimensions diagonal(const MatrixDimensions& m) { return {m.head.head, m.tail.tail}; }

}  // namespace halfway::reference
