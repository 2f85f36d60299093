// When a wrong twin counts as seen.
#pragma once

#include "verify/findings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <string>
#include <utility>

namespace halfway::verify {

/// A mutant is caught when its defect exceeds the limit that the healthy twin keeps 100 times over.
inline constexpr double kMargin = 100;

inline std::vector<Finding> verdicts(const std::string& name, const std::string& measure,
                                     const Measurement& mutant, const Measurement& healthy, double limit) {
  Finding seen = at_most(
      name, "mutants", mutant, 1, "of the defect", Oracle::independent,
      fmt::format("{} must show the mutant {} times beyond its limit of {:.3g}; shown: 1 = just seen, "
                  "smaller = seen more clearly",
                  measure, kMargin, limit));
  seen.value = mutant.value > 0 ? kMargin * limit / mutant.value : HUGE_VAL;
  // A function that returns NaN where it should not is seen as well.
  if (std::isnan(mutant.value)) seen.value = 0;
  seen.parameter = fmt::format("{} = {:.3g} at {}", measure, mutant.value, mutant.where);
  return {reference::judged(seen),
          at_most(name + "/healthy", "mutants", healthy, limit, "", Oracle::independent,
                  "the limit of " + measure + " for the twin without the mistake")};
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
