// How far a joint may be turned whose energy is a series: up to where it is no longer convex.
#pragma once

#include "reference/face/registry.hpp"

#include <string>

namespace halfway::reference {

/// |theta|, rad, within which the formulation's energy is convex for the joint's law, of its stiffness at no
/// strain. Infinity: it has no such limit. 0: its law has to have a positive definite angular stiffness, and
/// has none.
double convex_radius(const Entry& entry, const JointSpec& spec);

/// "rod4: rotation of 0.41 rad is beyond 0.34 rad, within which its energy is convex for this stiffness".
std::string beyond_convexity(const Entry& entry, double phi, double radius);

/// The same without the name.
std::string beyond_convexity(double phi, double radius);

}  // namespace halfway::reference
