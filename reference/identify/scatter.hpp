// How uncertain unknowns are whose weights were found from the same numbers as they are.
#pragma once

#include "reference/identify/data.hpp"

#include <vector>

namespace halfway::reference::identify {

struct Scatter {
  Eigen::MatrixXd covariance;  ///< of the unknowns, weights taken as known, at a variance of 1
  Eigen::VectorXd inflation;   ///< of each variance, >= 1: by what the weights themselves scatter
  Eigen::VectorXd degrees;     ///< of freedom behind each variance
  /// Numbers of a channel less the unknowns that it pays for, the trace of its share of the hat matrix.
  std::array<double, kChannels> left{};
};

/// Least squares with a variance for each channel, found from what is left (restricted maximum likelihood).
/// Weights that scatter make the unknowns scatter more, and the plain covariance, taken at those weights,
/// says less than it is, both by the same amount to first order: Kackar and Harville 1984, Kenward and Roger
/// 1997, whose adjustment this is; degrees of freedom by Satterthwaite 1946.
/// @param J        derivatives by the unknowns, each row over its standard deviation
/// @param channel  of each row
/// @param found    which channels' variances were found; the others have weights that do not scatter
Scatter scatter_of(const Eigen::MatrixXd& J, const std::vector<int>& channel,
                   const std::array<bool, kChannels>& found);

}  // namespace halfway::reference::identify
