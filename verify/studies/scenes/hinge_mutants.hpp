// Solvers that call a hinge converged when it is not, each by one mistake, beside the one of the library.
#pragma once

#include "reference/scene/scene.hpp"

namespace halfway::verify {

/// theta_x of a planar hinge at load factor 1 by an attached joint, rad.
double hinge_by_solver(const reference::Scene& scene);
/// The imbalance is taken for rounding once it is that of the stiffest direction.
double hinge_by_stiffest_entry(const reference::Scene& scene);
/// A small correction is taken for rounding.
double hinge_by_small_step(const reference::Scene& scene);
/// The pose of the node is the unknown: strains are differences of positions, moments those about the node.
double hinge_by_positions(const reference::Scene& scene);

}  // namespace halfway::verify
