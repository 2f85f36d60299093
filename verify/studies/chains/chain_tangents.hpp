// What a wrong tangent costs a chain: the same equilibrium, reached by other Newton iterations.
#pragma once

#include "verify/studies/chains/chain_rods.hpp"

#include <string>
#include <vector>

namespace halfway::verify {

struct TangentCost {
  std::string name;        ///< of the tangent
  bool converged = false;  ///< within the iterations allowed
  int iterations = 0;      ///< in all load steps, restarts included
  int load_steps = 0;
  double seconds = 0;  ///< of this thread, to the answer
  Vec3<double> tip = Vec3<double>::Zero();
};

/// Of straight_anisotropic with 64 links, each tangent in the fewest of 1, 4, 16, 64 and 256 load steps that
/// arrive. The exact one first; computed once.
const std::vector<TangentCost>& tangent_costs(const reference::Entry& entry);

}  // namespace halfway::verify
