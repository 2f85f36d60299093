// What measures a failure once more: the request of `halfway eval` that has its pose and its law, or the
// scene that `halfway run` solves.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/solve/equilibrium_problem.hpp"

#include <string>

namespace halfway::verify {

/// One line of JSON. A compliance is written as the stiffness that it is.
std::string eval_request(const std::string& formulation, const reference::JointSpec& spec,
                         const Pose<double>& a, const Pose<double>& b);

/// A scene file of one formulation. @param setting  what a file cannot say: told in its description
std::string scene_text(const reference::Scene& scene, const reference::Entry& entry, double xi,
                       const reference::Setting& setting = {});

}  // namespace halfway::verify
