// A structure-preserving integrator: kick with the joint, drift of free rigid bodies, both exact maps.
//
// The kick changes the momenta at fixed poses. The drift leaves the momenta alone and turns each body about
// its principal axes in turn, five turns that are their own mirror image. For loads with a potential every
// part is the flow of a Hamiltonian, so the whole is symplectic and its energy error stays bounded; for any
// loads it is symmetric in time, and forces that balance conserve both momenta to rounding.
#pragma once

#include "reference/solve/dynamics/bodies.hpp"

namespace halfway::reference::dynamics {

/// Order of convergence: the second-order scheme, or Yoshida's composition of three of it.
enum class Order { two, four };

/// `steps` steps of size h (s), negative: back in time. System::dissipation is ignored: the loads must depend
/// on the poses alone, those of System::drive on the time besides. Its work is that of each kick, exactly.
void advance(const System& system, Order order, double h, long steps, State& state, Driven& driven);

/// The same from time 0, of a system that nothing drives or of whose work nobody asks.
inline void advance(const System& system, Order order, double h, long steps, State& state) {
  Driven from_start;
  advance(system, order, h, steps, state, from_start);
}

}  // namespace halfway::reference::dynamics
