// Scenes in time solved: what each formulation's motion is at the scene's times, with an honest outcome.
#pragma once

#include "reference/scene/mechanism_scene.hpp"
#include "reference/solve/solve.hpp"

namespace halfway::reference {

/// Rows are the scene's points, evenly over the time, the first its start; errors are those of the bodies'
/// motions, rad and m, the worst of all: against the same motion at a hundredth of the tolerance, or from
/// half the step by the order of the splitting. Never throws for a motion that ends early: the outcome says
/// so. Of the curve, `iterations` counts evaluations of all loads, `residual` is how far the energy balance
/// is off, over the largest energy that was there.
Curve solve_motion(const MechanismScene& scene, const Choice& choice, const Told& told = {});

}  // namespace halfway::reference
