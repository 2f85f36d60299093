#include "reference/solve/stability/critical_zeros.hpp"

namespace halfway::reference {
namespace {

const Real50 kRounding50("1e-40");

/// The zero between a and b, where the values have other signs (Illinois: a secant that keeps the bracket);
/// nothing at a pole, where the value does not shrink.
std::optional<Real50> zero_between(const Function50& f, Real50 a, Real50 b) {
  Real50 fa = f(a).value, fb = f(b).value;
  const Real50 start = abs(fa) < abs(fb) ? abs(fa) : abs(fb), width("1e-42");
  Real50 last = b, f_last = fb;
  for (int i = 0; i < 100 && abs(b - a) > width && f_last != Real50(0); ++i) {
    const Real50 next = (a * fb - b * fa) / (fb - fa);
    f_last = f(next).value;
    const bool done = abs(next - last) <= width;
    last = next;
    if (done) break;
    if ((f_last < Real50(0)) != (fb < Real50(0))) {
      a = b;
      fa = fb;
    } else {
      fa /= Real50(2);
    }
    b = next;
    fb = f_last;
  }
  if (abs(f_last) > start * Real50(1e-6)) return std::nullopt;
  return last;
}

/// The zero at which the value goes from positive to negative. Where two modes pass each other without
/// meeting the discriminant only touches zero: such a zero is cut off and the search goes on beside it.
std::optional<Real50> descending_zero(const Function50& f, Real50 from, Real50 to) {
  const Real50 beside(1e-12), none(0);
  for (int i = 0; i < 6; ++i) {
    const auto zero = zero_between(f, from, to);
    if (!zero) return std::nullopt;
    const Real50 before = *zero - beside, after = *zero + beside;
    if (f(after).value > none)
      from = after;
    else if (f(before).value < none)
      to = before;
    else
      return zero;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Real50> sign_change(const Function50& f, double from, double to) {
  if (f(Real50(from)).value * f(Real50(to)).value > Real50(0)) return std::nullopt;
  return zero_between(f, Real50(from), Real50(to));
}

std::optional<Real50> first_negative(const Function50& f, double step, double to) {
  const auto negative = [&](double angle) {
    const Signed<Real50> s = f(Real50(angle));
    return s.value < -kRounding50 * s.size;
  };
  if (!negative(to)) return std::nullopt;  // rounding where it touches zero
  double from = to - step;
  while (from > 0 && negative(from)) {
    to = from;
    from -= step;
  }
  if (from <= step / 2) {
    const Signed<Real50> s = f(Real50(0));
    if (s.value <= kRounding50 * s.size) return Real50(0);  // equal rates: complex from the first load on
    from = 0;
  }
  return descending_zero(f, Real50(from), Real50(to));
}

}  // namespace halfway::reference
