// What becomes of the energy in a run in time, for its summary.
#pragma once

#include "reference/scene/mechanism_scene.hpp"
#include "reference/solve/solve.hpp"

#include <string>
#include <vector>

namespace halfway::reports {

/// Two lines: how far the balance of the formulations with a potential is off, by the integration, and what
/// those without one make or lose by themselves.
std::string energy_words(const reference::MechanismScene& scene, const std::vector<reference::Curve>& curves);

}  // namespace halfway::reports
