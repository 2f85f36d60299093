// The [joint] table of a scene file.
#pragma once

#include "reference/face/joint_spec.hpp"
#include "reference/scene/scene_fields.hpp"

namespace halfway::reference {

/// Throws SceneError.
JointSpec read_joint(const Field& joint);

}  // namespace halfway::reference
