// Complex numbers as the variable of an analytic function, for the complex step.
//
// Eigen is told that they are real, so that a dot product or a transpose conjugates nothing: a conjugate or a
// modulus is not analytic, and would lose the derivative in the imaginary part. Comparisons, which only
// choose among branches of the same function, look at the real part.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <complex>

namespace halfway::bench {

struct Complex {
  std::complex<double> z;

  Complex() = default;
  Complex(double real) : z(real) {}
  Complex(int real) : z(real) {}
  Complex(const std::complex<double>& value) : z(value) {}

  Complex operator-() const { return -z; }
  Complex& operator+=(const Complex& o) { return z += o.z, *this; }
  Complex& operator-=(const Complex& o) { return z -= o.z, *this; }
  Complex& operator*=(const Complex& o) { return z *= o.z, *this; }
  Complex& operator/=(const Complex& o) { return z /= o.z, *this; }

  friend Complex operator+(const Complex& a, const Complex& b) { return a.z + b.z; }
  friend Complex operator-(const Complex& a, const Complex& b) { return a.z - b.z; }
  friend Complex operator*(const Complex& a, const Complex& b) { return a.z * b.z; }
  friend Complex operator/(const Complex& a, const Complex& b) { return a.z / b.z; }
  friend bool operator==(const Complex& a, const Complex& b) { return a.z.real() == b.z.real(); }
  friend auto operator<=>(const Complex& a, const Complex& b) { return a.z.real() <=> b.z.real(); }

  friend Complex sqrt(const Complex& a) { return std::sqrt(a.z); }
  friend Complex sin(const Complex& a) { return std::sin(a.z); }
  friend Complex cos(const Complex& a) { return std::cos(a.z); }
  friend Complex atan(const Complex& a) { return std::atan(a.z); }
};

}  // namespace halfway::bench

template <>
struct halfway::RealDigits<halfway::bench::Complex> : halfway::RealDigits<double> {};

namespace Eigen {
template <>
struct NumTraits<halfway::bench::Complex> : NumTraits<double> {
  using Real = halfway::bench::Complex;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  enum { IsComplex = 0, RequireInitialization = 1, ReadCost = 2, AddCost = 2, MulCost = 6 };
};
}  // namespace Eigen
