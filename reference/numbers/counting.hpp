// A scalar that counts what is done with it: the flops of templated code, without reading the code.
#pragma once

#include "halfway/rotations/scalar.hpp"

#include <Eigen/Core>

#include <cmath>
#include <compare>
#include <limits>
#include <type_traits>
#include <utility>

namespace halfway::reference {

/// Operations that were done, as the code is written: a compiler may merge some of them. Changes of
/// sign (negation, abs, copysign) are bit operations and count as nothing.
struct OperationCount {
  long additions = 0;  ///< and subtractions
  long multiplications = 0;
  long divisions = 0;
  long roots = 0;
  long comparisons = 0;  ///< min and max included
  long functions = 0;    ///< calls of sin, atan2, exp, ...: their own operations are not known
  long undefined = 0;    ///< of all these, those with a NaN among their operands: poison shows what is read

  /// Floating-point operations: a division or a root is one, an fma two, a function none.
  long flops() const { return additions + multiplications + divisions + roots; }

  friend bool operator==(const OperationCount&, const OperationCount&) = default;
};

namespace detail {
inline thread_local OperationCount operations;
}

/// What `work` does in this thread with numbers of CountingOf<R>.
template <class Work>
OperationCount counted(const Work& work) {
  const OperationCount outer = std::exchange(detail::operations, {});
  work();
  return std::exchange(detail::operations, outer);
}

/// An R, so branches go where they go in R, whose operations are counted.
template <class R>
class CountingOf {
 public:
  CountingOf() = default;
  template <class N>
  requires std::is_arithmetic_v<N> CountingOf(N value) : v_(R(value)) {}
  template <class N>
  requires std::is_arithmetic_v<N>
  explicit operator N() const { return N(v_); }

  CountingOf operator-() const { return CountingOf(-v_); }
  CountingOf& operator+=(const CountingOf& o) { return *this = *this + o; }
  CountingOf& operator-=(const CountingOf& o) { return *this = *this - o; }
  CountingOf& operator*=(const CountingOf& o) { return *this = *this * o; }
  CountingOf& operator/=(const CountingOf& o) { return *this = *this / o; }

  friend CountingOf operator+(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::additions, a, b), CountingOf(a.v_ + b.v_);
  }
  friend CountingOf operator-(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::additions, a, b), CountingOf(a.v_ - b.v_);
  }
  friend CountingOf operator*(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::multiplications, a, b), CountingOf(a.v_ * b.v_);
  }
  friend CountingOf operator/(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::divisions, a, b), CountingOf(a.v_ / b.v_);
  }
  friend CountingOf fma(const CountingOf& a, const CountingOf& b, const CountingOf& c) {
    const CountingOf product(a.v_ * b.v_);  // counted only: the result is rounded once
    count(&OperationCount::multiplications, a, b), count(&OperationCount::additions, product, c);
    return CountingOf(std::fma(a.v_, b.v_, c.v_));
  }

  friend bool operator==(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::comparisons, a, b), a.v_ == b.v_;
  }
  friend std::partial_ordering operator<=>(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::comparisons, a, b), a.v_ <=> b.v_;
  }
  friend CountingOf min(const CountingOf& a, const CountingOf& b) { return b < a ? b : a; }
  friend CountingOf max(const CountingOf& a, const CountingOf& b) { return a < b ? b : a; }

  friend CountingOf abs(const CountingOf& a) { return CountingOf(std::abs(a.v_)); }
  friend CountingOf fabs(const CountingOf& a) { return abs(a); }
  friend CountingOf copysign(const CountingOf& a, const CountingOf& sign) {
    return CountingOf(std::copysign(a.v_, sign.v_));
  }
  friend bool signbit(const CountingOf& a) { return std::signbit(a.v_); }
  friend bool isfinite(const CountingOf& a) { return std::isfinite(a.v_); }
  friend bool isnan(const CountingOf& a) { return std::isnan(a.v_); }

  friend CountingOf sqrt(const CountingOf& a) {
    return count(&OperationCount::roots, a, a), CountingOf(std::sqrt(a.v_));
  }

#define HALFWAY_COUNTED_FUNCTION(name)                                              \
  friend CountingOf name(const CountingOf& a) {                                     \
    return count(&OperationCount::functions, a, a), CountingOf(R(std::name(a.v_))); \
  }
  HALFWAY_COUNTED_FUNCTION(sin)
  HALFWAY_COUNTED_FUNCTION(cos)
  HALFWAY_COUNTED_FUNCTION(tan)
  HALFWAY_COUNTED_FUNCTION(asin)
  HALFWAY_COUNTED_FUNCTION(acos)
  HALFWAY_COUNTED_FUNCTION(atan)
  HALFWAY_COUNTED_FUNCTION(exp)
  HALFWAY_COUNTED_FUNCTION(log)
#undef HALFWAY_COUNTED_FUNCTION
  friend CountingOf atan2(const CountingOf& y, const CountingOf& x) {
    return count(&OperationCount::functions, y, x), CountingOf(std::atan2(y.v_, x.v_));
  }
  friend CountingOf pow(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::functions, a, b), CountingOf(std::pow(a.v_, b.v_));
  }
  friend CountingOf hypot(const CountingOf& a, const CountingOf& b) {
    return count(&OperationCount::functions, a, b), CountingOf(std::hypot(a.v_, b.v_));
  }

 private:
  static void count(long OperationCount::*what, const CountingOf& a, const CountingOf& b) {
    ++(detail::operations.*what);
    if (std::isnan(a.v_) || std::isnan(b.v_)) ++detail::operations.undefined;
  }

  R v_{};
};

using Counting = CountingOf<double>;

}  // namespace halfway::reference

/// The limits of R: code that asks for digits or epsilon does what it does in R.
template <class R>
struct std::numeric_limits<halfway::reference::CountingOf<R>> : std::numeric_limits<R> {};

namespace Eigen {
template <class R>
struct NumTraits<halfway::reference::CountingOf<R>> : NumTraits<R> {
  using Real = halfway::reference::CountingOf<R>;
  using NonInteger = Real;
  using Nested = Real;
  using Literal = Real;
  static Real epsilon() { return NumTraits<R>::epsilon(); }
  static Real dummy_precision() { return NumTraits<R>::dummy_precision(); }
  static Real highest() { return NumTraits<R>::highest(); }
  static Real lowest() { return NumTraits<R>::lowest(); }
};
}  // namespace Eigen
