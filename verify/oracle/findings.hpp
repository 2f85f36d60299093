// The two kinds of finding that the identity, table and mutant checks make.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/measures.hpp"

namespace halfway::verify {

/// A relative or absolute error that must not exceed `limit`, with the worst case it was measured at.
inline Finding at_most(const std::string& name, const char* subject, const Measurement& m, double limit,
                       const char* unit, Oracle oracle, const std::string& reason) {
  return finding(name).about(subject).measured(m).in(unit).at_most(limit, reason).by(oracle);
}

/// A failure that must be seen: its size must lie between `low` and `high`.
inline Finding known_defect(const std::string& name, const char* subject, const Measurement& m, double low,
                            double high, Oracle oracle, const std::string& reason) {
  return finding(name).about(subject).measured(m).within(low, high, reason).by(oracle);
}

}  // namespace halfway::verify
