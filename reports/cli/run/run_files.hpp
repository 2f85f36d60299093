// The curves of one scene as text: CSV, JSON, and a table for the terminal.
#pragma once

#include "reports/cli/run/run_choices.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

/// "invariant", or "intrinsic xi=0.25" where xi is free.
std::string curve_label(const reference::Curve& curve);

/// Its xi with 17 digits; "" where it is not free.
std::string xi_text(const reference::Curve& curve);

/// One row per point of every curve: formulation, xi (empty where it is not free), factor, outputs, their
/// estimated error (rad, m; empty by arc length), and in a curve's last row its outcome.
/// Numbers have 17 significant digits.
std::string curves_csv(const std::vector<reference::Curve>& curves);

/// One row per formulation: formulation, xi, axis (1, 2, 3, of the joint), critical_moment (N m),
/// critical_angle (rad, from the unstrained pose); the last two empty where there is none below pi.
std::string critical_csv(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves);

/// {"schema": "halfway-run-1", "scene", "title", "curves": [...], "left_out": [...]}; rows follow "columns".
/// Where the scene has a critical_axis, each curve has "critical": {"axis", "moment", "angle"}, or null where
/// there is none.
std::string curves_json(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves,
                        const std::vector<NotRun>& left_out);

/// The last row of every curve with outcome, estimated error, iterations and residual, and the critical state
/// where asked; then what was left out and why.
std::string curves_table(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves,
                         const std::vector<NotRun>& left_out);

}  // namespace halfway::reports
