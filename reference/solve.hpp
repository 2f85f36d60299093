// Scenes solved: the curve of each formulation, with an honest outcome.
#pragma once

#include "reference/registry.hpp"
#include "reference/scene.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

/// The path of one formulation through one scene.
struct Curve {
  std::string scene;
  std::string formulation;
  double xi = 0.5;
  std::vector<std::string> columns;           ///< "factor", then the scene's outputs
  std::vector<std::vector<double>> rows;      ///< as many as converged; NaN never
  bool converged = false;                     ///< up to the scene's last load factor
  std::string outcome;                        ///< for people: "converged" or why not, and where
  int iterations = 0;                         ///< Newton iterations of the whole path
  double residual = 0;                        ///< at the last point, relative to the load
};

/// Solves `scene` with one formulation (and xi, where it has one). Never throws for a path that
/// ends early: the outcome says so.
Curve solve_scene(const Scene& scene, const Entry& entry, double xi);

/// The formulations (and xi) that a scene asks for: {entry, xi}, the catalog's order.
struct Choice {
  const Entry* entry;
  double xi;
};
std::vector<Choice> choices(const Scene& scene);

}  // namespace halfway::reference
