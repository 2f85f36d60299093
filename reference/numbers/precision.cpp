#include "reference/numbers/precision.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>

#include <new>

namespace halfway::reference {

using Number =
    boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
static_assert(std::numeric_limits<Number>::digits == RealDigits<Real50>::value);

/// The storage holds one trivially copyable Number, made in place.
struct Real50::Access {
  static_assert(sizeof(Number) <= sizeof(storage_) && alignof(Number) <= 16);
  static_assert(std::is_trivially_destructible_v<Number>);

  static Number& of(Real50& r) { return *std::launder(reinterpret_cast<Number*>(r.storage_)); }
  static const Number& of(const Real50& r) {
    return *std::launder(reinterpret_cast<const Number*>(r.storage_));
  }
  static void make(Real50& r, const Number& n) { new (r.storage_) Number(n); }
  static Real50 from(const Number& n) {
    Real50 r;
    of(r) = n;
    return r;
  }
};

Real50::Real50(double value) { Access::make(*this, Number(value)); }
Real50::Real50(long value) { Access::make(*this, Number(value)); }
Real50::Real50(long double value) { Access::make(*this, Number(value)); }
Real50::Real50(const char* decimal) { Access::make(*this, Number(decimal)); }

Real50::operator double() const { return Access::of(*this).convert_to<double>(); }
Real50::operator long double() const { return Access::of(*this).convert_to<long double>(); }
std::string Real50::str(int digits) const { return Access::of(*this).str(digits); }

Real50 Real50::operator-() const { return Access::from(-Access::of(*this)); }
Real50& Real50::operator+=(const Real50& o) { return Access::of(*this) += Access::of(o), *this; }
Real50& Real50::operator-=(const Real50& o) { return Access::of(*this) -= Access::of(o), *this; }
Real50& Real50::operator*=(const Real50& o) { return Access::of(*this) *= Access::of(o), *this; }
Real50& Real50::operator/=(const Real50& o) { return Access::of(*this) /= Access::of(o), *this; }

bool operator==(const Real50& a, const Real50& b) { return Real50::Access::of(a) == Real50::Access::of(b); }
std::partial_ordering operator<=>(const Real50& a, const Real50& b) {
  const Number &x = Real50::Access::of(a), &y = Real50::Access::of(b);
  if (x < y) return std::partial_ordering::less;
  if (x > y) return std::partial_ordering::greater;
  return x == y ? std::partial_ordering::equivalent : std::partial_ordering::unordered;
}

#define HALFWAY_UNARY(name)                                                          \
  Real50 name(const Real50& a) {                                                     \
    return Real50::Access::from(boost::multiprecision::name(Real50::Access::of(a))); \
  }
HALFWAY_UNARY(abs)
HALFWAY_UNARY(sqrt)
HALFWAY_UNARY(sin)
HALFWAY_UNARY(cos)
HALFWAY_UNARY(tan)
HALFWAY_UNARY(atan)
#undef HALFWAY_UNARY

Real50 atan2(const Real50& y, const Real50& x) {
  return Real50::Access::from(boost::multiprecision::atan2(Real50::Access::of(y), Real50::Access::of(x)));
}
bool isfinite(const Real50& a) { return boost::multiprecision::isfinite(Real50::Access::of(a)); }

Real50 pi50() { return Real50("3.14159265358979323846264338327950288419716939937510582"); }

}  // namespace halfway::reference
