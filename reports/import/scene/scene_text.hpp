// An imported joint as a scene file: what a person reads, and what our own reader reads.
#pragma once

#include "reports/import/record/imported.hpp"

#include <string>

namespace halfway::imports {

/// A load that turns or moves the joint a little, for files that hold none.
struct ExampleLoad {
  bool is_moment = true;        ///< fixed_moment, else fixed_force
  Vec3<double> value{0, 0, 0};  ///< N m or N, global axes
  Vec3<double> point{0, 0, 0};  ///< of the force, axes of b, m
  std::string said{};           ///< "a moment of 3.2 N m: about 0.1 rad"
};

/// Stays below 0.1 rad and 1 mm of the softest spring: about an axis alone where the joint is a hinge. Throws
/// reference::Refusal where nothing is stiff.
ExampleLoad example_load(const ImportedJoint& joint);

/// @param file  as the caller named it
/// @param formulation  the joint's own, or what --as says
std::string scene_text(const ImportedJoint& joint, const std::string& file, const std::string& formulation,
                       const ExampleLoad& load);

/// Stiffness at rest of all strains: K, or the tables' slopes there.
Eigen::MatrixXd stiffness_at_rest(const ImportedJoint& joint);

/// Letters, digits, _ and - of a name, for a file's.
std::string file_name_of(const std::string& name);

}  // namespace halfway::imports
