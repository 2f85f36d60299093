// Strains that meet no stiffness: hinges and slides.
#pragma once

#include "reference/face/joint_spec.hpp"

#include <optional>
#include <string>

namespace halfway::reference {

/// The stiffness of a law at no strain, n x n; of a compliance an empty matrix: it is stiff everywhere.
Eigen::MatrixXd rest_stiffness(const LawSpec& law, Kind kind);

/// 1 / sqrt of each block's largest diagonal entry: strains times it compare m with rad.
Eigen::VectorXd strain_units(const Eigen::MatrixXd& K);

/// Strains of no stiffness, one a column, in m and rad; no column when there is none.
Eigen::MatrixXd free_strains(const Eigen::MatrixXd& K);

/// Does the law have a stiffness at other strains along that one? A curve with play, or without a linear
/// part.
bool is_slack(const LawSpec& law, const Eigen::VectorXd& free_strain);

/// Where the stiffness of a curve jumps, within a hundredth of where a strain is: the strain's place and the
/// corner, m or rad. None of laws that are smooth.
struct Corner {
  Eigen::Index strain;
  double at;
};
std::optional<Corner> corner_near(const LawSpec& law, const Eigen::VectorXd& strain);

/// "rotation about joint axis 3", "translation along joint axis 1", or the strain itself where it is along no
/// axis of the joint.
std::string strain_name(const Eigen::VectorXd& strain, Kind kind);

}  // namespace halfway::reference
