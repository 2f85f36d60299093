// Equilibrium paths of the block of C3 through buckling, by arc length and by load steps: computed once,
// judged and drawn.
#pragma once

#include "reference/solve/paths/branches.hpp"
#include "reference/solve/paths/continuation_load_steps.hpp"

namespace halfway::verify {

inline constexpr const char* kBlockPathScene = "c3_buckling";

/// Up to the whole load of the scene.
reference::ContinuationOptions whole_load();

/// The path of the unstrained pose under the skewed moment.
struct BlockPath {
  explicit BlockPath(const reference::Entry& entry);
  reference::Continuation continuation;
  reference::EquilibriumPath path;
};
const BlockPath& skewed_path(const reference::Entry& entry);

/// Whole load steps under the same moment, and which of their states are not on the path.
struct BlockSteps {
  reference::LoadSteps newton, gsl;
  reference::OffPath newton_off, gsl_off;
};
const BlockSteps& load_steps(const reference::Entry& entry, int count);

/// The paths of the moment along the axis: all that hang together.
struct BlockBranches {
  explicit BlockBranches(const reference::Entry& entry);
  reference::Continuation continuation;
  std::vector<reference::Branch> branches;
};
const reference::Scene& straight_block();
const BlockBranches& straight_branches(const reference::Entry& entry);

}  // namespace halfway::verify
