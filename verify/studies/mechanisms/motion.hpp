// Scenes in time for the checks: from a text with words replaced, and one that no person would write.
#pragma once

#include "reference/mechanism/motion/solve_motion.hpp"
#include "verify/check.hpp"

#include <map>
#include <string>

namespace halfway::verify {

/// Of a text of a scene. Throws SceneError.
reference::MechanismScene scene_of(std::string text, const std::map<std::string, std::string>& words);

/// The scene solved with one formulation, xi as it is probed.
reference::Curve moved(const reference::MechanismScene& scene, const char* formulation);

/// A body on an angular joint, in frames turned on both nodes: one axis of it is a principal axis of the
/// inertia and of the law, and a moment about it grows. Words: INTEGRATION, MOMENT, DAMPING, START.
extern const char* const kTorsion;
/// J phi'' + c phi' + k phi = M(t), M growing to MOMENT within half a second, from START rad at rest.
struct Torsion {
  double c, M, start;
  double J = 5e-3, k = 0.3, ramp = 0.5;  ///< kg m^2, N m/rad, s
  double angle(double t) const;
};

/// Two bodies off their centres of mass, three joints in a loop that does not fit together, dampers that
/// couple, loads of all sorts, two of which change; moving from the start on.
reference::MechanismScene generic_motion(const reference::Entry& entry);

}  // namespace halfway::verify
