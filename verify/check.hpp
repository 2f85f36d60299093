// A check: a named measurement that returns findings. verify runs them under Boost.Test and ctest,
// reports runs them for the page; both see the same list.
#pragma once

#include "reference/record/effort.hpp"
#include "reference/record/finding.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::verify {

using reference::by_effort;
using reference::Comparison;
using reference::Draft;
using reference::finding;
using reference::Finding;
using reference::is_quick;
using reference::Oracle;
using reference::sampled;
using reference::Verdict;

struct Check {
  std::string name;   ///< formulation/kind/property, identities/..., or scene/formulation
  std::string label;  ///< ctest label: the room of its file below studies/, set from checks.def
  std::function<std::vector<Finding>()> run;
};

using Checks = std::vector<Check>;

/// All checks of checks.def, in its order. A check = one file in checks/ and its line there.
Checks all_checks();

}  // namespace halfway::verify
