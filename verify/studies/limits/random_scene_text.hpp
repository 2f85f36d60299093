// Scene files with random mistakes: what a slipping hand, a broken disk or a bad script makes of one.
#pragma once

#include "reference/numbers/random.hpp"

#include <string>

namespace halfway::reference {

/// A scene that is right, with one to three mistakes: lines lost, doubled or exchanged, values of another
/// type or size, bytes changed, the end missing. Some stay right.
std::string random_scene_text(Generator& random);

}  // namespace halfway::reference
