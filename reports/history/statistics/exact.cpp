#include "reports/history/statistics/exact.hpp"

#include <fmt/format.h>

#include <cmath>

namespace halfway::statistics {
namespace {

constexpr const char* kVerdicts[] = {"pass", "known_failure", "left_out", "fail"};

/// Two numbers that are the same, NaN too.
bool same(double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }

Sense sense_of(bool better, bool worse) {
  return worse ? Sense::regression : better ? Sense::improvement : Sense::change;
}

double resolved(double error, double limit) {
  const double least = limit > 0 ? 1e-3 * limit : std::numeric_limits<double>::epsilon();
  return std::abs(error) < least ? least : std::abs(error);  // a NaN stays one
}

std::string number(double x) { return std::isnan(x) ? "not measured" : fmt::format("{}", x); }

std::string moved(const char* what, const std::string& from, const std::string& to) {
  return fmt::format("{}{} -> {}", what, from, to);
}

}  // namespace

Verdict verdict_of(std::string_view text) {
  for (const Verdict v : {Verdict::pass, Verdict::known_failure, Verdict::left_out})
    if (text == kVerdicts[int(v)]) return v;
  return Verdict::fail;
}

const char* to_string(Verdict verdict) { return kVerdicts[int(verdict)]; }

double digits_gained(const Exact& before, const Exact& after) {
  // The same scale for both: a limit that moved must not move the digits.
  const double limit = std::fmin(before.limit, after.limit);  // of one alone, where the other has none
  return std::log10(resolved(before.error, limit) / resolved(after.error, limit));
}

std::optional<ExactChange> exact_change(const Exact& before, const Exact& after) {
  if (before.verdict != after.verdict) {
    const bool worse = after.verdict > before.verdict;
    return ExactChange{sense_of(!worse, worse), digits_gained(before, after),
                       moved("", to_string(before.verdict), to_string(after.verdict)) +
                           moved("; ", number(before.value), number(after.value))};
  }
  if (!same(before.limit, after.limit)) {
    const bool tighter = after.limit < before.limit || std::isnan(before.limit);
    return ExactChange{sense_of(tighter, !tighter), digits_gained(before, after),
                       moved("limit ", number(before.limit), number(after.limit))};
  }
  if (same(before.value, after.value)) return std::nullopt;
  const std::string values = moved("", number(before.value), number(after.value));
  if (std::isnan(before.value) || std::isnan(after.value)) {
    const bool gone = std::isnan(after.value);
    return ExactChange{sense_of(!gone, gone), digits_gained(before, after), values};
  }
  if (before.is_count) {
    const bool more = after.value > before.value;
    return ExactChange{sense_of(!more, more), std::numeric_limits<double>::quiet_NaN(), values};
  }
  const double digits = digits_gained(before, after);
  const char* const how = digits < 0 ? "digits lost" : "digits gained";
  return ExactChange{
      sense_of(digits >= 1, digits <= -1), digits,
      std::isnan(digits) ? values : fmt::format("{}, {:.1f} {}", values, std::abs(digits), how)};
}

}  // namespace halfway::statistics
