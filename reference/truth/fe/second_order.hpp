// Second-order couplings of a solid by perturbation: one factorization, every law at once.
#pragma once

#include "reference/truth/couplings.hpp"
#include "reference/truth/fe/statics.hpp"

namespace halfway::reference::fe {

/// The compliance at the reference point and the quadratic couplings of each law, in the order of kLaws.
struct SecondOrder {
  Mat6 compliance;
  std::array<Couplings, kLaws.size()> couplings;
};

/// linear: the six first-order fields of the same solid. Loads keep their direction; theta = log(R).
SecondOrder second_order(const Solid& solid, const Statics::Linear& linear);

}  // namespace halfway::reference::fe
