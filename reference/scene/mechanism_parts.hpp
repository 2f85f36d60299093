// The tables of a mechanism's scene file: bodies, joints, loads, motions.
#pragma once

#include "reference/scene/mechanism_scene.hpp"
#include "reference/scene/text/fields.hpp"

namespace halfway::reference {

/// [[body]] and [[joint]] (or [joint]); each joint without `between` is between the bodies a, clamped, and b.
/// Throws Refusal, as all of these.
void read_bodies_and_joints(const Field& file, MechanismScene& scene);

/// [[motion]], in a scene with bodies.
void read_motions(const Field& file, MechanismScene& scene);

/// [[load]], in a scene with bodies that stand somewhere; none are needed beside motions or
/// in time.
void read_body_loads(const Field& file, MechanismScene& scene);

/// The table [[body]] of that name, or the whole file where the name is used without one.
Field body_field(const Field& file, const std::string& name);

}  // namespace halfway::reference
