// What a scene in time can ask of a moment.
#pragma once

#include "reference/mechanism/motion/moving_scene.hpp"

namespace halfway::reference::mechanism {

/// Energies at a moment, J.
struct Energies {
  double kinetic = 0, strain = 0, dissipated = 0, work = 0;
  double total() const { return kinetic + strain + dissipated - work; }
};

/// A moment of a motion.
struct Moment {
  dynamics::State state;
  Moving now;
  Energies energies;
};

/// One output of those that the reader names for scenes in time. @param at_start  total energy of the start,
/// J
double motion_output(const MovingScene& moving, const Moment& moment, double at_start,
                     const std::string& name);

}  // namespace halfway::reference::mechanism
