// The two kinds of finding that the identity, table and mutant checks make.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/measures.hpp"

namespace halfway::verify {

/// A relative or absolute error that must not exceed `limit`, with the worst case it was measured at.
inline Finding at_most(const std::string& name, const char* subject, const Measurement& m, double limit,
                       const char* unit, Oracle oracle, const std::string& reason) {
  Finding f;
  f.name = name;
  f.subject = subject;
  f.parameter = m.where;
  f.value = m.value;
  f.unit = unit;
  f.high = limit;
  f.oracle = oracle;
  f.reason = reason;
  return reference::judged(f);
}

/// A failure that must be seen: its size must lie between `low` and `high`.
inline Finding known_defect(const std::string& name, const char* subject, const Measurement& m, double low,
                            double high, Oracle oracle, const std::string& reason) {
  Finding f = at_most(name, subject, m, high, "", oracle, reason);
  f.low = low;
  f.comparison = Comparison::within;
  return reference::judged(f);
}

}  // namespace halfway::verify
