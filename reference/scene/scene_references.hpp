// The [[reference]] tables of a scene file.
#pragma once

#include "reference/scene/fields.hpp"
#include "reference/scene/scene.hpp"

namespace halfway::reference {

/// The reference values of one table, checked against `scene`, which is complete but for its
/// references. Throws Refusal.
std::vector<SceneReference> read_reference_set(const Field& set, const Scene& scene);

}  // namespace halfway::reference
