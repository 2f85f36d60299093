// All the paths of a scene that hang together: the one of the unstrained pose, and those that cross it.
#pragma once

#include "reference/solve/paths/continuation.hpp"

#include <string>
#include <vector>

namespace halfway::reference {

struct Branch {
  std::string name;  ///< "primary"; "second 1+", "second 1-": the halves of the path at the first branching
  EquilibriumPath path;
};

/// The primary path first; then both halves of the other path at each of its branchings.
std::vector<Branch> branches(const Continuation& continuation);

/// The scene with its fixed moments turned onto one axis, their size kept: the limit without skew.
/// @param axis  0, 1 or 2, of the scene
Scene without_skew(const Scene& scene, int axis);

}  // namespace halfway::reference
