// What a slender rod does in a scene of one angular joint: the curve "rod" of `run --rod`.
#pragma once

#include "reference/solve/solve.hpp"

namespace halfway::reports {

/// Of the straight uniform rod that the joint stands for, GJ/L, EI2/L, EI3/L being its stiffness, to all
/// orders: the outputs of the scene at its load factors. Throws BadInput for what is no rod under an end
/// moment: another kind, a law that is not linear and positive definite, loads that are no moments fixed in
/// space.
reference::Curve rod_curve(const reference::Scene& scene);

/// The same at other load factors, ascending from 0 on.
reference::Curve rod_curve(const reference::Scene& scene, const std::vector<double>& factors);

}  // namespace halfway::reports
