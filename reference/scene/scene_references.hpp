// The [[reference]] tables of a scene file.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/scene_fields.hpp"

namespace halfway::reference {

/// The reference values of one table, checked against `scene`, which is complete but for its
/// references. Throws SceneError.
std::vector<SceneReference> read_reference_set(const Field& set, const Scene& scene);

/// Names of all formulations of the catalog, in its order.
std::vector<std::string> formulation_names();

}  // namespace halfway::reference
