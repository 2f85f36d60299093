// What changed in a figure that comes out the same on every run: verdicts, limits and digits, never a ratio.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace halfway::statistics {

enum class Verdict { pass, known_failure, left_out, fail };  ///< from good to bad

/// "pass", "known_failure", "left_out", "fail"; anything else is a fail.
Verdict verdict_of(std::string_view text);
const char* to_string(Verdict verdict);

enum class Sense { improvement, change, regression };

/// One reading of a deterministic figure.
struct Exact {
  double value = std::numeric_limits<double>::quiet_NaN();  ///< NaN: nothing was measured
  double error = std::numeric_limits<double>::quiet_NaN();  ///< a size whose digits count; NaN: none do
  double limit = std::numeric_limits<double>::quiet_NaN();  ///< of the error, the largest allowed; NaN: none
  bool is_count = false;                                    ///< of work: more is worse
  Verdict verdict = Verdict::pass;
};

struct ExactChange {
  Sense sense = Sense::change;
  double digits = std::numeric_limits<double>::quiet_NaN();  ///< gained; negative: lost; NaN: not counted
  std::string text;                                          ///< what changed, for a person
};

/// Decimal digits that the error gained from `before` to `after`. Both count as no smaller than a thousandth
/// of the limit (without one, than eps): what lies so far below is the luck of rounding.
double digits_gained(const Exact& before, const Exact& after);

/// Nothing where both are the same. A regression is a worse verdict, a value that is gone, a wider limit, a
/// digit lost, or a larger count. The error's digits count whole: another order of operations moves half of
/// one (1.1e-16 -> 3.3e-16), and that is a change like any other.
std::optional<ExactChange> exact_change(const Exact& before, const Exact& after);

}  // namespace halfway::statistics
