// One check run apart, in a process of its own: a crash or an endless loop is an outcome like any other.
#pragma once

#include "verify/check.hpp"
#include "verify/oracle/saboteurs/saboteur.hpp"

#include <functional>

namespace halfway::verify {

enum class Outcome { passed, failed, threw, crashed, hung };

const char* to_string(Outcome outcome);

struct Trial {
  Outcome outcome = Outcome::crashed;
  std::string by{};       ///< the first finding that failed, or what was thrown
  bool judges = false;    ///< has a finding that a finite value can fail
  bool left_out = false;  ///< all its findings are
  Parts seen{};           ///< where a witness is in use: what the check asked for
  bool caught() const { return outcome == Outcome::failed || outcome == Outcome::threw; }
};

/// Runs the check in a child process of at most `limit` CPU seconds. `seen` is read in there after the run.
Trial run_apart(const Check& check, int limit, const Parts& seen = {});

}  // namespace halfway::verify
