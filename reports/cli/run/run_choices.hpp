// Which scene and which formulations `halfway run` was asked for.
#pragma once

#include "reference/scene/any_scene.hpp"
#include "reference/solve/solve.hpp"

#include <functional>
#include <string>
#include <vector>

namespace halfway::reports {

/// The canonical scene or the chain of that name, or the scene in that file. Throws BadInput or SceneError.
reference::AnyScene find_scene(const std::string& name_or_file);

/// How the formulations fit a scene.
struct Fit {
  std::vector<reference::Choice> asked;  ///< by the scene itself
  /// What is against one, such as "takes no coupling"; "" for nothing. No entry: the linear analysis.
  std::function<std::string(const reference::Entry*)> objection;
};
Fit fit_of(const reference::Scene& scene);

/// The formulations by name, or the scene's own choice when `names` is empty; `xis` replaces the
/// scene's values for those that have a free xi. Throws BadInput.
std::vector<reference::Choice> run_choices(const reference::SceneHead& scene, const Fit& fit,
                                           const std::vector<std::string>& names,
                                           const std::vector<double>& xis);

/// A formulation that is not run although nobody chose otherwise, and why.
struct NotRun {
  std::string formulation, reason;
};
std::vector<NotRun> left_out(const reference::SceneHead& scene, const Fit& fit,
                             const std::vector<reference::Choice>& choices);

}  // namespace halfway::reports
