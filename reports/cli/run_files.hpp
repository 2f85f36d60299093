// The curves of one scene as text: CSV, JSON, and a table for the terminal.
#pragma once

#include "reports/cli/run_choices.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

/// "invariant", or "intrinsic xi=0.25" where xi is free.
std::string curve_label(const reference::Curve& curve);

/// One row per point of every curve: formulation, xi (empty where it is not free), factor, outputs.
/// Numbers have 17 significant digits.
std::string curves_csv(const std::vector<reference::Curve>& curves);

/// {"schema": "halfway-run-1", "scene", "title", "curves": [...], "left_out": [...]}; rows follow "columns".
std::string curves_json(const reference::Scene& scene, const std::vector<reference::Curve>& curves,
                        const std::vector<LeftOut>& left_out);

/// The last row of every curve with outcome, iterations and residual; then what was left out and why.
std::string curves_table(const std::vector<reference::Curve>& curves, const std::vector<LeftOut>& left_out);

}  // namespace halfway::reports
