// Where the bodies of a scene in time are when it begins.
#pragma once

#include "reference/scene/mechanism_scene.hpp"
#include "reference/solve/solve.hpp"

namespace halfway::reference::mechanism {

struct Beginning {
  std::vector<Pose<double>> nodes;  ///< of each body, global axes
  double error = 0;                 ///< that an equilibrium tells of itself, rad or m
  std::string cause{};              ///< why there is none to begin with; "": there is
};

/// As the bodies say, or at the equilibrium that the loads of time 0 reach as they grow together from
/// nothing, by the one Newton. A load that jumps at time 0 has its value before the jump there.
Beginning beginning(const MechanismScene& scene, const Choice& choice);

}  // namespace halfway::reference::mechanism
