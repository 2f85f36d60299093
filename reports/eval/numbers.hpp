// Numbers as JSON, with the fewest digits that give them back. All have to be finite.
#pragma once

#include <Eigen/Core>

#include <string>

namespace halfway::reports {

void append_number(std::string& out, double value);
/// [1,2,3], at most 12
void append_row(std::string& out, const Eigen::Ref<const Eigen::VectorXd>& values);
/// [[1,2],[3,4]], of 12 x 12
void append_rows(std::string& out, const Eigen::Matrix<double, 12, 12>& values);

}  // namespace halfway::reports
