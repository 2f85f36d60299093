// The [[reference]] tables of a scene file.
#pragma once

#include "reference/scene/scene.hpp"
#include "reference/scene/text/fields.hpp"

namespace halfway::reference {

/// The reference values of one table, checked against `scene`, which is complete but for its
/// references. Beside formulations values may be of `truth`, what all of them approximate, where it has a
/// name. Throws Refusal.
std::vector<SceneReference> read_reference_set(const Field& set, const SceneHead& scene,
                                               std::string_view truth);

}  // namespace halfway::reference
