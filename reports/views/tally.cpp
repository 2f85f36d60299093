#include "reports/views/tally.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace halfway::reports {

using reference::Comparison;
using reference::Finding;
using reference::Verdict;

Tally tally(const std::vector<Finding>& findings) {
  Tally out;
  for (const Finding& finding : findings) {
    switch (finding.verdict) {
      case Verdict::pass:
        ++out.pass;
        break;
      case Verdict::fail:
        ++out.fail;
        break;
      case Verdict::known_failure:
        ++out.known_failure;
        break;
      case Verdict::left_out:
        ++out.left_out;
        break;
    }
  }
  return out;
}

const Finding* find_finding(const Results& results, const std::string& name) {
  const auto found = std::find_if(results.findings.begin(), results.findings.end(),
                                  [&](const Finding& finding) { return finding.name == name; });
  return found == results.findings.end() ? nullptr : &*found;
}

const bench::Timing* find_timing(const Results& results, const std::string& formulation,
                                 const std::string& kind, const std::string& what) {
  for (const char* implementation : {"kernel", "reference"}) {
    const auto found =
        std::find_if(results.timings.begin(), results.timings.end(), [&](const bench::Timing& timing) {
          return timing.implementation == implementation && timing.formulation == formulation &&
                 timing.kind == kind && timing.what == what && timing.precision == "double" &&
                 timing.variant.empty() && timing.method.empty();
        });
    if (found != results.timings.end()) return &*found;
  }
  return nullptr;
}

std::string explain(const Finding& f) {
  if (f.verdict == Verdict::left_out) return f.reason;
  const std::string unit = f.unit.empty() ? "" : " " + f.unit;
  std::string text = fmt::format("value {:.17g}{}", f.value, unit);
  switch (f.comparison) {
    case Comparison::at_most:
      text += fmt::format(", at most {:.6g}{}", f.high, unit);
      break;
    case Comparison::at_least:
      text += fmt::format(", at least {:.6g}{}", f.low, unit);
      break;
    case Comparison::within:
      text += fmt::format(", band {:.6g} to {:.6g}{}", f.low, f.high, unit);
      break;
    case Comparison::equal:
      text += fmt::format(", expected {:.17g} within {:.3g}{}", f.expected, f.high, unit);
      break;
    case Comparison::report:
      break;
  }
  if (const std::string why = missing(f); !why.empty()) text += "; " + why;
  if (!f.parameter.empty()) text += "; worst case: " + f.parameter;
  if (!f.reason.empty()) text += "; why this limit: " + f.reason;
  return text;
}

}  // namespace halfway::reports
