// What tests of imports share: a text becomes a scene as `halfway import` would write it, read by our own
// reader.
#pragma once

#include "reference/scene/scene.hpp"
#include "reports/import/readers/readers.hpp"

#include <string>

namespace halfway::imports::test {

/// A file of tests/samples.
std::string sample(const std::string& name);

/// The written scene of a joint, read back.
reference::Scene written_scene(const ImportedJoint& joint, const std::string& as = "");

/// The only bushing of a text.
ImportedJoint only_joint(const std::string& text, const ImportOptions& options = {});

/// Forces and moments on both nodes by a scene's joint; the first of its formulations.
Eigen::Matrix<double, 12, 1> loads_of(const reference::Scene& scene, const Pose<double>& a,
                                      const Pose<double>& b);

/// Largest error of (f_a, m_a, f_b, m_b): forces over the larger force, moments over the larger moment. NaN
/// where something is none.
double load_error(const Eigen::Matrix<double, 12, 1>& measured, const Eigen::Matrix<double, 12, 1>& truth);

/// All digits, between `between`.
std::string words(const Eigen::VectorXd& values, const char* between);

/// A pose by a rotation vector and a place, made by Eigen.
Pose<double> pose_at(const Eigen::Vector3d& rotation, const Eigen::Vector3d& place);

}  // namespace halfway::imports::test
