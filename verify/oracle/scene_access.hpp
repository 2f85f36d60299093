// Scenes by name and their solutions, for the checks that ask for one.
#pragma once

#include "reference/solve/path.hpp"
#include "verify/check.hpp"

#include <string>

namespace halfway::verify {

/// The canonical scenes, read once.
const std::vector<reference::Scene>& scenes();

/// The canonical scene of that name; throws std::runtime_error when it is missing.
const reference::Scene& scene(const std::string& name);

/// Outputs theta (rad) of a scene at a load factor, solved at 50 digits. Throws std::runtime_error
/// when the path does not reach the factor.
Vec3<reference::Real50> rotation_at(const std::string& scene_name, const reference::Entry& entry, double xi,
                                    double factor);

/// The diagonal of the scene's linear compliance law: 3 values, or 6 with translation first.
Eigen::VectorXd compliances(const reference::Scene& scene);

}  // namespace halfway::verify
