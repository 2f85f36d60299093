#include "reports/history/record/exact.hpp"

namespace halfway::history {

statistics::Exact exact_of(const Figure& figure, const Reading& r) {
  statistics::Exact out{
      .value = r.value, .error = error_of(r), .limit = limit_of(r), .is_count = figure.kind == Kind::count};
  if (r.comparison == Comparison::at_least) out.limit = -r.low;
  if (r.comparison == Comparison::within) out.limit = r.high - r.low;
  // The error of what is timed: reported, and its digits count.
  if (r.comparison == Comparison::report && figure.better == Better::down) out.error = r.value;
  if (r.verdict != Verdict::none) out.verdict = statistics::verdict_of(to_string(r.verdict));
  return out;
}

}  // namespace halfway::history
