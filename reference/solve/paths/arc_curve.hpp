// A scene's curve by arc length: on through folds, where load stepping ends.
#pragma once

#include "reference/solve/solve.hpp"

namespace halfway::reference {

/// As solve_scene, with rows in the order of the path: the load factor may fall. The outcome names the
/// singular points on the way and what ended the path; converged: it reached the scene's last load factor.
Curve follow_by_arc(const Scene& scene, const Choice& choice);

}  // namespace halfway::reference
