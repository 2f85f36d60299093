// Dual numbers v + e d, e^2 = 0: exact first derivatives by a road that shares no tangent formula.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <Eigen/Core>

#include <cmath>

namespace halfway::reference {

/// Value and derivative along one direction.
template <class R>
struct Dual {
  R v{};
  R d{};

  Dual() = default;
  Dual(const R& value) : v(value), d(0) {}
  Dual(const R& value, const R& derivative) : v(value), d(derivative) {}
  template <class N>
  requires(std::is_arithmetic_v<N> && !std::is_same_v<N, R>) Dual(N value) : v(value), d(0) {}
  explicit operator int() const { return int(v); }
  explicit operator double() const { return double(v); }

  Dual operator-() const { return {-v, -d}; }
  Dual& operator+=(const Dual& o) { return *this = *this + o; }
  Dual& operator-=(const Dual& o) { return *this = *this - o; }
  Dual& operator*=(const Dual& o) { return *this = *this * o; }
  Dual& operator/=(const Dual& o) { return *this = *this / o; }

  friend Dual operator+(const Dual& a, const Dual& b) { return {a.v + b.v, a.d + b.d}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.v - b.v, a.d - b.d}; }
  friend Dual operator*(const Dual& a, const Dual& b) { return {a.v * b.v, a.v * b.d + a.d * b.v}; }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const R q = a.v / b.v;
    return {q, (a.d - q * b.d) / b.v};
  }
  friend bool operator==(const Dual& a, const Dual& b) { return a.v == b.v; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.v != b.v; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.v <= b.v; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.v >= b.v; }

  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const R r = sqrt(a.v);
    return {r, a.d / (R(2) * r)};
  }
  friend Dual sin(const Dual& a) {
    using std::cos, std::sin;
    return {sin(a.v), cos(a.v) * a.d};
  }
  friend Dual cos(const Dual& a) {
    using std::cos, std::sin;
    return {cos(a.v), -sin(a.v) * a.d};
  }
  friend Dual atan(const Dual& a) {
    using std::atan;
    return {atan(a.v), a.d / (R(1) + a.v * a.v)};
  }
  friend Dual atan2(const Dual& y, const Dual& x) {
    using std::atan2;
    return {atan2(y.v, x.v), (x.v * y.d - y.v * x.d) / (x.v * x.v + y.v * y.v)};
  }
  friend Dual abs(const Dual& a) { return a.v < R(0) ? -a : a; }
};

}  // namespace halfway::reference

template <class R>
struct halfway::RealDigits<halfway::reference::Dual<R>> : halfway::RealDigits<R> {};

namespace Eigen {
template <class R>
struct NumTraits<halfway::reference::Dual<R>> : NumTraits<R> {
  using Real = halfway::reference::Dual<R>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 2,
    AddCost = 2,
    MulCost = 4
  };
};
}  // namespace Eigen
