// Scenes of chains solved: the tip against the load factor, and the shape at each.
#pragma once

#include "reference/scene/chain_scene.hpp"
#include "reference/solve/solve.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

/// The nodes 0 ... N at one load factor.
struct Shape {
  double factor;
  std::vector<chain::Node> nodes;
};

/// One formulation's answer to a scene of a chain.
struct ChainAnswer {
  Curve curve;                ///< of the tip; errors are those of the algebra alone, m or rad
  std::vector<Shape> shapes;  ///< at each load factor of `curve`, the first at rest
  bool stopped = false;       ///< by `told`
};

/// Who is told of each iteration of a solution: (iterations done, most that are allowed); false: stop.
using ChainTold = std::function<bool(int done, int most)>;

/// The chain of the scene with joints of one formulation.
chain::Chain chain_of(const ChainScene& scene, const Choice& choice);

/// What a formulation whose energy is a series has against a solution: that a joint turns beyond where its
/// energy is convex, where an equilibrium may be another than the rod's. "" for nothing, and of all others.
std::string beyond_series(const Entry& entry, const chain::Chain& chain,
                          const std::vector<chain::Node>& nodes);

chain::EndLoads scaled(const chain::EndLoads& loads, double factor);

/// Solves the scene at each of its load factors, from rest. Where one is not reached the outcome says why,
/// and the curve ends before it. Throws std::invalid_argument where the formulation has no batch.
ChainAnswer solve_chain_scene(const ChainScene& scene, const Choice& choice, const ChainTold& told = {});

}  // namespace halfway::reference
