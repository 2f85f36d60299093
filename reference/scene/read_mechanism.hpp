// Scene files of mechanisms.
#pragma once

#include "reference/scene/mechanism_scene.hpp"
#include "reference/scene/text/fields.hpp"

#include <filesystem>

namespace halfway::reference {

/// Does a file with a joint say more than a joint between a clamped and a loaded node: several joints,
/// bodies, motions, steps, or outputs that a mechanism has alone?
bool is_mechanism(const Field& file);

/// The whole of such a file. Throws Refusal.
MechanismScene mechanism_scene(const Field& file, const std::filesystem::path& path);

}  // namespace halfway::reference
