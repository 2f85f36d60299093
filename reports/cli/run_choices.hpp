// Which scene and which formulations `halfway run` was asked for.
#pragma once

#include "reference/solve/solve.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

/// The canonical scene of that name, or the scene in that file. Throws BadInput or SceneError.
reference::Scene find_scene(const std::string& name_or_file);

/// The formulations by name, or the scene's own choice when `names` is empty; `xis` replaces the
/// scene's values for those that have a free xi. Throws BadInput.
std::vector<reference::Choice> run_choices(const reference::Scene& scene,
                                           const std::vector<std::string>& names,
                                           const std::vector<double>& xis);

/// A formulation that is not run although nobody chose otherwise, and why.
struct LeftOut {
  std::string formulation, reason;
};
std::vector<LeftOut> left_out(const reference::Scene& scene, const std::vector<reference::Choice>& choices);

}  // namespace halfway::reports
