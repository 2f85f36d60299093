// Strains that meet no stiffness: hinges and slides.
#pragma once

#include "reference/face/joint_spec.hpp"

#include <string>

namespace halfway::reference {

/// A stiffness, n x n, that is zero where the law has none at all: a linear law's own; of another one the
/// slopes at its own zero strain on the diagonal, and where such a slope is zero and the curve is not, the
/// block's largest. Of a compliance an empty matrix: it is stiff everywhere.
Eigen::MatrixXd rest_stiffness(const LawSpec& law);

/// 1 / sqrt of each block's largest diagonal entry: strains times it compare m with rad.
Eigen::VectorXd strain_units(const Eigen::MatrixXd& K);

/// Strains of no stiffness, one a column, in m and rad; no column when there is none.
Eigen::MatrixXd free_strains(const Eigen::MatrixXd& K);

/// "rotation about joint axis 3", "translation along joint axis 1", or the strain itself where it is along no
/// axis of the joint.
std::string strain_name(const Eigen::VectorXd& strain, Kind kind);

}  // namespace halfway::reference
