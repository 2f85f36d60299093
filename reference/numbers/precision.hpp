// 50-digit arithmetic: the road that sees rounding.
//
// Real50 is a number of MPFR, correctly rounded, behind out-of-line operators: what is instantiated in it for
// every formulation sees these declarations alone.
#pragma once

#include "halfway/rotations/scalar.hpp"
#include "reference/numbers/matrices50.hpp"

#include <Eigen/Core>

#include <compare>
#include <string>

namespace halfway::reference {

class Real50 {
 public:
  Real50();  ///< zero
  Real50(double value);
  Real50(int value) : Real50(double(value)) {}
  Real50(long value);
  explicit Real50(long double value);
  /// Decimal literal, all 50 digits kept. Throws std::runtime_error when it is not a number.
  explicit Real50(const char* decimal);

  explicit operator double() const;
  explicit operator float() const { return float(double(*this)); }
  explicit operator long double() const;
  explicit operator int() const { return int(double(*this)); }
  /// Decimal with `digits` significant digits.
  std::string str(int digits) const;

  Real50 operator-() const { return negative(*this); }
  Real50& operator+=(const Real50& o) { return *this = *this + o; }
  Real50& operator-=(const Real50& o) { return *this = *this - o; }
  Real50& operator*=(const Real50& o) { return *this = *this * o; }
  Real50& operator/=(const Real50& o) { return *this = *this / o; }
  friend Real50 operator+(const Real50& a, const Real50& b);
  friend Real50 operator-(const Real50& a, const Real50& b);
  friend Real50 operator*(const Real50& a, const Real50& b);
  friend Real50 operator/(const Real50& a, const Real50& b);
  friend bool operator==(const Real50& a, const Real50& b);
  friend std::partial_ordering operator<=>(const Real50& a, const Real50& b);

  friend Real50 abs(const Real50& a);
  friend Real50 sqrt(const Real50& a);
  friend Real50 sin(const Real50& a);
  friend Real50 cos(const Real50& a);
  friend Real50 tan(const Real50& a);
  friend Real50 atan(const Real50& a);
  friend Real50 atan2(const Real50& y, const Real50& x);
  friend bool isfinite(const Real50& a);

 private:
  static Real50 negative(const Real50& a);
  struct Access;  // precision.cpp: MPFR's number on these limbs; no pointer is kept, so that bytes can be
                  // copied
  int kind_;
  long exponent_;
  unsigned long limbs_[3];
};

/// pi to 50 digits.
Real50 pi50();

}  // namespace halfway::reference

template <>
struct halfway::RealDigits<halfway::reference::Real50> {
  static constexpr int value = 168;
};

namespace Eigen {
template <>
struct NumTraits<halfway::reference::Real50> : GenericNumTraits<halfway::reference::Real50> {
  using Real = halfway::reference::Real50;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 4,
    AddCost = 40,
    MulCost = 60
  };
  static Real epsilon() { return Real("5.3455294e-51"); }  // 2^-167
  static Real dummy_precision() { return Real("1e-45"); }
  static int digits10() { return 50; }
};
}  // namespace Eigen

namespace halfway::reference {

/// What an equilibrium of six unknowns asks for, found there by its scalar and compiled once
/// (halfway/equilibrium/balance.hpp).
Eigen::Matrix<Real50, 6, 1> solved(const Eigen::Matrix<Real50, 6, 6>& J,
                                   const Eigen::Matrix<Real50, 6, 1>& r);
Eigen::Matrix<Real50, 6, 6> inverse_of(const Eigen::Matrix<Real50, 6, 6>& J);

}  // namespace halfway::reference
