// Joints with directions of no stiffness, hinges and slides: an equilibrium exists where no load works there.
#pragma once

#include "reference/solve/solve.hpp"

#include <optional>
#include <string>

namespace halfway::reference {

/// The scene with its free directions, but those of has_play(), held by `hold` times the law's own stiffness;
/// nothing when there is none. What holds them carries nothing while no load works there: then the answer
/// does not depend on `hold`.
std::optional<Scene> held(const Scene& scene, double hold);

/// Is there a direction without stiffness at rest alone (play, a curve without linear part) on which the load
/// works? From rest no path leads there, and no equilibrium is near.
bool has_play(const Scene& scene);

/// The scene with those directions held by next to nothing of its load at that factor: it comes to an
/// equilibrium near one of the scene's own.
Scene eased(const Scene& scene, double factor);

/// Do two curves end at the same place, to a billionth of their largest output?
bool agree(const Curve& a, const Curve& b);

/// Why a scene of that kind has no equilibrium of its own, if its load works on a free direction at rest.
std::optional<std::string> works_on_free_direction(const Scene& scene);

}  // namespace halfway::reference
