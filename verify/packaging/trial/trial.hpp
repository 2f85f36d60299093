// A formulation added from outside, by this header and one line of a catalog: 3 tan(phi/3) n in the
// half-way frame, a measure that the suite's catalog does not have. Conjugate, hence without any defect.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

struct Trial : Family<FrameHalfway, VectorialMeasure<detail::TangentFactor<3>>, Conjugate> {
  static constexpr const char* name = "trial";
  static constexpr const char* stands_for = "a formulation tried out of tree";
  static constexpr Facts facts{};
};

}  // namespace halfway
