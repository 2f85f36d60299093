#include "reference/numbers/precision.hpp"

#include <mpfr.h>

#include <array>
#include <stdexcept>
#include <type_traits>

namespace halfway::reference {
namespace {

constexpr mpfr_prec_t kBits = RealDigits<Real50>::value;
constexpr mpfr_rnd_t kRounding = MPFR_RNDN;

}  // namespace

struct Real50::Access {
  static_assert(std::is_same_v<mpfr_exp_t, long> && std::is_same_v<mp_limb_t, unsigned long>);
  static_assert(kBits <= mpfr_prec_t(8 * sizeof(limbs_)));

  struct Number {
    mpfr_t x;
    /// MPFR writes to the limbs of results alone.
    explicit Number(const Real50& of) {
      mpfr_custom_init_set(x, of.kind_, of.exponent_, kBits, const_cast<unsigned long*>(of.limbs_));
    }
    operator mpfr_srcptr() const { return x; }
  };

  /// fn(result, MPFR's arguments...)
  template <class Fn, class... Args>
  static Real50 made(Fn fn, const Args&... args) {
    Real50 out;
    Number result(out);
    fn(result.x, args...);
    out.kind_ = mpfr_custom_get_kind(result.x);
    out.exponent_ = mpfr_custom_get_exp(result.x);
    return out;
  }
};

Real50::Real50() : kind_(MPFR_ZERO_KIND), exponent_(0), limbs_{} {}
Real50::Real50(double value) : Real50(Access::made([&](mpfr_ptr x) { mpfr_set_d(x, value, kRounding); })) {}
Real50::Real50(long value) : Real50(Access::made([&](mpfr_ptr x) { mpfr_set_si(x, value, kRounding); })) {}
Real50::Real50(long double value)
    : Real50(Access::made([&](mpfr_ptr x) { mpfr_set_ld(x, value, kRounding); })) {}
Real50::Real50(const char* decimal)
    : Real50(Access::made([&](mpfr_ptr x) {
        if (mpfr_set_str(x, decimal, 10, kRounding) != 0)
          throw std::runtime_error("'" + std::string(decimal) + "' is no decimal number");
      })) {}

Real50::operator double() const { return mpfr_get_d(Access::Number(*this), kRounding); }
Real50::operator long double() const { return mpfr_get_ld(Access::Number(*this), kRounding); }
std::string Real50::str(int digits) const {
  std::array<char, 256> text;
  const int size =
      mpfr_snprintf(text.data(), text.size(), "%.*Rg", digits, mpfr_srcptr(Access::Number(*this)));
  return {text.data(), std::size_t(size)};
}

#define HALFWAY_UNARY(name, function)                                                           \
  Real50 name(const Real50& a) {                                                                \
    return Real50::Access::made([](mpfr_ptr x, mpfr_srcptr of) { function(x, of, kRounding); }, \
                                Real50::Access::Number(a));                                     \
  }
HALFWAY_UNARY(Real50::negative, mpfr_neg)
HALFWAY_UNARY(abs, mpfr_abs)
HALFWAY_UNARY(sqrt, mpfr_sqrt)
HALFWAY_UNARY(sin, mpfr_sin)
HALFWAY_UNARY(cos, mpfr_cos)
HALFWAY_UNARY(tan, mpfr_tan)
HALFWAY_UNARY(atan, mpfr_atan)
#undef HALFWAY_UNARY

#define HALFWAY_BINARY(name, function)                                                              \
  Real50 name(const Real50& a, const Real50& b) {                                                   \
    return Real50::Access::made(                                                                    \
        [](mpfr_ptr x, mpfr_srcptr of, mpfr_srcptr and_of) { function(x, of, and_of, kRounding); }, \
        Real50::Access::Number(a), Real50::Access::Number(b));                                      \
  }
HALFWAY_BINARY(operator+, mpfr_add)
HALFWAY_BINARY(operator-, mpfr_sub)
HALFWAY_BINARY(operator*, mpfr_mul)
HALFWAY_BINARY(operator/, mpfr_div)
HALFWAY_BINARY(atan2, mpfr_atan2)
#undef HALFWAY_BINARY

bool operator==(const Real50& a, const Real50& b) {
  return mpfr_equal_p(Real50::Access::Number(a), Real50::Access::Number(b)) != 0;
}
std::partial_ordering operator<=>(const Real50& a, const Real50& b) {
  const Real50::Access::Number x(a), y(b);
  if (mpfr_unordered_p(x, y) != 0) return std::partial_ordering::unordered;
  return mpfr_cmp(x, y) <=> 0;
}
bool isfinite(const Real50& a) { return mpfr_number_p(Real50::Access::Number(a)) != 0; }

Real50 pi50() { return Real50("3.14159265358979323846264338327950288419716939937510582"); }

}  // namespace halfway::reference
