// The same answers by other roads.
#pragma once

#include "reports/advise/core/advice.hpp"

namespace halfway::advise {

/// The truth at some load factors: of a rod by collocation, of a chain by iterating K theta = exp(theta/2)^T
/// m link by link; of data the data. Throws std::runtime_error where it has none.
Answers truth_again(const Advice& advice, const std::vector<double>& factors);

/// A candidate by the kernel that is timed, in double and in a turned and shifted frame; of the linear
/// analysis K^-1 m.
Answers model_again(const reference::Scene& scene, const Candidate& candidate,
                    const std::vector<double>& factors);

}  // namespace halfway::advise
