// Scenes of mechanisms solved: the curve of each formulation, with an honest outcome.
#pragma once

#include "reference/mechanism/outputs.hpp"
#include "reference/solve/solve.hpp"

#include <optional>

namespace halfway::reference {

/// Those that the scene asks for and its joints allow; the linear analysis is of one joint alone.
std::vector<Choice> choices(const MechanismScene& scene);

/// Solves with one choice. Never throws for a path that ends early: the outcome says so, and names flutter,
/// divergence and, where the scene asks, the first singular tangent.
Curve solve_scene(const MechanismScene& scene, const Choice& choice, const Told& told = {});

/// The first load factor up to `end` at which the tangent's determinant changes its sign, seen from one
/// point of the path to the next: two changes between them, and double roots, are overlooked.
std::optional<double> critical_factor(const MechanismScene& scene, const Choice& choice);

}  // namespace halfway::reference
