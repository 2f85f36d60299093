// Mechanisms that no person would write: frames and offsets on both nodes, coupled stiffness, loads of every
// sort at once.
#pragma once

#include "reference/mechanism/solve.hpp"
#include "reference/solve/path.hpp"
#include "verify/check.hpp"

namespace halfway::verify {

/// A probe's joint under loads of every type, each of which alone would turn it by about `angle`, rad; the
/// first is held.
reference::Scene generic_scene(const reference::Entry& entry, Kind kind, double angle);

/// The same as a mechanism of one joint, posed as Setting says.
reference::MechanismScene as_mechanism(const reference::Scene& scene, const reference::Setting& setting = {});

/// Two free bodies and three joints in a loop that does not fit together at rest; loads on both bodies. Dead
/// forces alone, one of them held, where `dead` says so.
reference::MechanismScene generic_loop(const reference::Entry& entry, bool dead);

/// Everything in other axes at another place.
reference::MechanismScene carried(const reference::MechanismScene& scene, const Vec3<double>& turn,
                                  const Vec3<double>& shift);

/// A joint with either node listed first.
void exchange_nodes(reference::SceneJoint& joint);

}  // namespace halfway::verify
