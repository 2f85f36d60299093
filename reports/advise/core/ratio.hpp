// The same scene with its stiffnesses nearer to each other or farther apart.
#pragma once

#include "reports/advise/core/advice.hpp"

namespace halfway::advise {

/// Largest over smallest angular stiffness; nothing of a law that is not linear and positive definite.
std::optional<double> stiffness_ratio(const reference::Scene& scene);

/// The scene with that ratio: principal stiffnesses k_i become g (k_i / g)^s about their geometric mean g,
/// the ratio 1 has none; of a law without direction (ratio 1) they are drawn apart as 1, sqrt(ratio), ratio
/// along its joint axes.
reference::Scene with_ratio(const reference::Scene& scene, double ratio);

/// Can the question be asked of another ratio? Of a rod, a chain, or without truth.
bool has_other_ratios(const Advice& advice);

/// The candidate advised at that ratio and rotation (rad); its name, "" for none.
std::string advised_at(const Advice& advice, const std::map<std::string, Cost>& costs, double ratio);

void add_ratio_margin(const Advice& advice, const std::map<std::string, Cost>& costs, Margin& out);

}  // namespace halfway::advise
