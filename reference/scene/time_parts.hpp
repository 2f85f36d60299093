// What a scene in time says: its integrator, where its bodies begin, dampers, loads over the time.
#pragma once

#include "reference/scene/mechanism_scene.hpp"
#include "reference/scene/text/fields.hpp"

namespace halfway::reference {

/// The table [time], in place of [path]. Throws Refusal, as all of these.
void read_time(const Field& file, MechanismScene& scene);

/// What stands beside it and is of equilibria alone, and what a motion needs: masses, no damper in a
/// splitting. Of a scene that is read.
void check_time(const Field& file, const MechanismScene& scene);

/// The table `start` of a body.
SceneStart read_start(const Field& table, const MechanismScene& scene, const SceneBody& body);

/// `times` and `factors` of a load.
void read_times(const Field& load, const MechanismScene& scene, BodyLoad& out);

/// Does the body need a mass, an inertia, that the file does not say?
bool lacks_mass(const SceneBody& body);

}  // namespace halfway::reference
