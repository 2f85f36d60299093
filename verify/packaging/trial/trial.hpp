// A formulation added from outside, by this header and one line of a catalog: the half-way frame with
// the conformal measure and projected moments, a choice that the suite's catalog does not have.
#pragma once

#include "formulations/family.hpp"

namespace halfway {

struct Trial : Family<FrameHalfway, ConformalMeasure, Projected> {
  static constexpr const char* name = "trial";
  static constexpr const char* stands_for = "a formulation tried out of tree";
  static constexpr Facts facts{.loop_slope = 4};
};

}  // namespace halfway
