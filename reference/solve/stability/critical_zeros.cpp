#include "reference/solve/stability/critical_zeros.hpp"

#include "reference/numbers/zeros.hpp"

namespace halfway::reference {
namespace {

const Real50 kRounding50("1e-40");

/// A point of the way and the function there.
struct Sample {
  Real50 distance, value;
};

/// The zero between a and b, where the values have other signs; nothing at a pole, where the value does not
/// shrink.
std::optional<Real50> zero_between(const Function50& f, const Real50& a, const Real50& b) {
  const auto at = [&](const Real50& x) { return Sample{x, f(x).value}; };
  Bracket bracket(at(a), at(b));
  const Real50 start = abs(bracket.nearer_to_zero().value), width("1e-42");
  Sample last = bracket.high();
  for (int i = 0; i < 100 && last.value != Real50(0); ++i) {
    const Sample next = at(bracket.guess());
    const bool settled = abs(next.distance - last.distance) <= width;
    last = next;
    if (settled) break;
    bracket.narrow(last);
  }
  if (abs(last.value) > start * Real50(1e-6)) return std::nullopt;
  return last.distance;
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

std::optional<Real50> double_zero(const Function50& determinant, const Function50& minors, double from,
                                  double to) {
  const auto between = sign_change(minors, from, to);
  if (!between) return std::nullopt;
  const Signed<Real50> there = determinant(*between);
  if (there.value < -kRounding50 * there.size) return zero_between(determinant, Real50(from), *between);
  return there.value <= kRounding50 * there.size ? between : std::nullopt;
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
