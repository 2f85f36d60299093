// Second-order theory: what is far out by it need not be computed.
#pragma once

#include "reports/advise/model/candidate.hpp"
#include "reports/advise/truth/truth.hpp"

namespace halfway::advise {

/// Against a truth that is the same from either end (a rod, a chain), the error of an angular joint at the
/// load factor, by the second-order terms of the formulation alone: | theta_2 - theta_2 of the truth | / |
/// theta_1 |. Nothing where the theory does not say it: another kind, law or load, an unknown formulation, or
/// rotations beyond which higher orders count.
std::optional<double> second_order_error(const Truth& truth, const Candidate& candidate, double factor);

/// An error this many times the tolerance by second-order theory is no matter of higher orders: below the
/// rotations where it is asked those are a quarter of it.
inline constexpr double kInDoubt = 4;

}  // namespace halfway::advise
