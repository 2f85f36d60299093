// Scenes that no person would write: any law, frames, offsets and loads from tiny to absurd.
#pragma once

#include "reference/numbers/random.hpp"
#include "reference/solve/path.hpp"

namespace halfway::reference {

struct RandomScene {
  Scene scene;
  Setting setting;
  double xi = 0.5;
};

/// A joint and loads for one formulation; what the formulation refuses (a coupled law) is not drawn.
/// Stiffnesses 1e-3 ... 1e9 with a ratio up to 1e8, full or diagonal, as stiffness or compliance, or a
/// polynomial that hardens or softens; offsets 1e-6 ... 1e3 m; loads of 1e-12 ... 1e6 times what strains
/// by one, one scene in twenty 1e-150 ... 1e150 times; either node loaded, anywhere in space.
RandomScene random_scene(Generator& random, const Entry& entry);

/// How far Newton at 50 digits goes from the state that Path reports to the equilibrium next to it: rad, and
/// for displacements relative to 1 m + |x|. NaN where it finds none: the state is none.
double distance_to_equilibrium(const RandomScene& random, const Entry& entry, const Outcome<double>& state);

/// Is all that Path reports a number: pose of the node, factor and residual?
bool is_finite(const RandomScene& random, const Entry& entry, const Outcome<double>& state);

}  // namespace halfway::reference
