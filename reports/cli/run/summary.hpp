// A run in about ten lines, for the terminal.
#pragma once

#include "reports/cli/run/comparison.hpp"

namespace halfway::reports {

/// Who agrees, the answers with their errors, how far they are apart, who ended early and why, what was left
/// out.
std::string summary_text(const reference::SceneHead& scene, const std::vector<reference::Curve>& curves,
                         const std::vector<NotRun>& left_out);

}  // namespace halfway::reports
