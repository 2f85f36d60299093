// Node order and balance of moments over the rotation, as the failure atlas draws them.
#pragma once

#include <string>
#include <vector>

namespace halfway::verify {

/// The defect of one formulation at rising rotations.
struct DefectSeries {
  std::string what;         ///< as the findings are called: node_order, moment_balance
  std::string formulation;  ///< of forces and moments together
  std::vector<double> phi;  ///< rad, 1e-4 to 3
  std::vector<double> error;
};

/// Of all formulations. The findings of these names judge the same measures at random rotations.
std::vector<DefectSeries> defect_series();

}  // namespace halfway::verify
