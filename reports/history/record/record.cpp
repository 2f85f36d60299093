#include "reports/history/record/record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <iterator>
#include <stdexcept>

namespace halfway::history {
namespace {

constexpr const char* kKinds[] = {"accuracy", "time", "count"};
constexpr const char* kBetters[] = {"down", "up", "none"};
constexpr const char* kComparisons[] = {"none", "at_most", "at_least", "within", "equal", "report"};
constexpr const char* kVerdicts[] = {"none", "pass", "known_failure", "fail", "left_out", "gone"};

template <class Enum, std::size_t n>
void find(const char* what, const char* const (&names)[n], const std::string& text, Enum& out) {
  const auto* found = std::find(std::begin(names), std::end(names), text);
  if (found == std::end(names))
    throw std::invalid_argument(fmt::format("{} '{}'; allowed: {}", what, text, fmt::join(names, ", ")));
  out = Enum(found - std::begin(names));
}

bool same_number(double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); }

}  // namespace

bool same(const Reading& a, const Reading& b) {
  return same_number(a.value, b.value) && a.comparison == b.comparison &&
         same_number(a.expected, b.expected) && same_number(a.low, b.low) && same_number(a.high, b.high) &&
         a.verdict == b.verdict;
}

std::int64_t seconds_of(const std::string& date) {
  std::tm utc{};
  const char* const end = ::strptime(date.c_str(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  if (end == nullptr || *end != '\0')
    throw std::invalid_argument(fmt::format("date '{}'; allowed: UTC such as 2026-11-29T04:32:45Z", date));
  return ::timegm(&utc);
}

double error_of(const Reading& r) {
  if (r.comparison == Comparison::at_most) return std::abs(r.value);
  if (r.comparison == Comparison::equal) return std::abs(r.value - r.expected);
  return kNone;
}

double limit_of(const Reading& r) {
  const bool has_error = r.comparison == Comparison::at_most || r.comparison == Comparison::equal;
  return has_error ? r.high : kNone;
}

double digits_of(double error) {
  return std::isnan(error) ? kNone : -std::log10(error < 1e-17 ? 1e-17 : error);
}

const char* to_string(Kind x) { return kKinds[int(x)]; }
const char* to_string(Better x) { return kBetters[int(x)]; }
const char* to_string(Comparison x) { return kComparisons[int(x)]; }
const char* to_string(Verdict x) { return kVerdicts[int(x)]; }
void from_string(const std::string& text, Kind& out) { find("kind", kKinds, text, out); }
void from_string(const std::string& text, Better& out) { find("better", kBetters, text, out); }
void from_string(const std::string& text, Comparison& out) { find("comparison", kComparisons, text, out); }
void from_string(const std::string& text, Verdict& out) { find("verdict", kVerdicts, text, out); }

}  // namespace halfway::history
