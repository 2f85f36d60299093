// Zeros of functions of one angle at 50 digits, when they are zeros and when they are not: a pole changes the
// sign too, and a discriminant touches zero where two modes pass each other without meeting.
#pragma once

#include "reference/numbers/precision.hpp"

#include <functional>
#include <optional>

namespace halfway::reference {

/// What must stay positive or keep its sign, and the size that its terms have.
template <class T>
struct Signed {
  T value, size;
};

using Function50 = std::function<Signed<Real50>(const Real50&)>;

/// Where the sign at `to` differs from that at `from`, rad, to 42 digits; nothing at a pole, or when 50
/// digits see no change.
std::optional<Real50> sign_change(const Function50& f, double from, double to);

/// Where a determinant goes through zero between two angles at which it is positive, twice in a row or by
/// touching zero: rad, of the first. Two roots have then changed their sign, and so has the sum of their
/// pairs' products. Nothing where that sum alone changes its sign.
std::optional<Real50> double_zero(const Function50& determinant, const Function50& minors, double from,
                                  double to);

/// Where f becomes negative on the way from 0 to `to`, usually within `step` of it; 0 when it is not
/// positive even there. Nothing when f is not negative at `to` beyond rounding, or at a pole.
std::optional<Real50> first_negative(const Function50& f, double step, double to);

}  // namespace halfway::reference
