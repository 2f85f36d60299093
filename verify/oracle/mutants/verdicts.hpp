// When a wrong twin counts as seen.
#pragma once

#include "verify/oracle/findings.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace halfway::verify {

/// Under a gross saboteur the wrong twin is healed: the check of a mutant has to fail then.
inline bool is_healed() { return tap_state().tap == Tap::gross; }

/// A mutant is caught when its defect exceeds the limit that the healthy twin keeps 100 times over.
inline constexpr double kMargin = 100;

inline std::vector<Finding> verdicts(const std::string& name, const std::string& measure,
                                     const Measurement& wrong, const Measurement& healthy, double limit) {
  const Measurement& mutant = is_healed() ? healthy : wrong;
  // A function that returns NaN where it should not is seen as well; a measure without any probe sees
  // nothing.
  const double share = mutant.is_empty()            ? std::nan("")
                       : std::isnan(mutant.value()) ? 0
                       : mutant.value() > 0         ? kMargin * limit / mutant.value()
                                                    : HUGE_VAL;
  return {
      finding(name)
          .about("mutants")
          .measured(share, fmt::format("{} = {:.3g} at {}", measure, mutant.value(), mutant.where()))
          .in("of the defect")
          .at_most(1, fmt::format("{} must show the mutant {} times beyond its limit of {:.3g}; shown: 1 = "
                                  "just seen, smaller = seen more clearly",
                                  measure, kMargin, limit))
          .by(Oracle::independent),
      at_most(name + "/healthy", "mutants", {tapped(healthy.value()), healthy.where()}, limit, "",
              Oracle::independent, "the limit of " + measure + " for the twin without the mistake")};
}

inline void add_mutant(Checks& checks, const char* name, const char* measure, double limit,
                       std::function<std::pair<Measurement, Measurement>()> run) {
  const std::string full = fmt::format("mutants/{}", name);
  checks.push_back({full, "mutants", [=]() -> std::vector<Finding> {
                      const auto [mutant, healthy] = run();
                      return verdicts(full, measure, mutant, healthy, limit);
                    }});
}

}  // namespace halfway::verify
