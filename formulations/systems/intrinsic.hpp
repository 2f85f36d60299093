// The paper's own forms: any frame xi, and the half-way one.
#pragma once

#include "formulations/family.hpp"

namespace halfway {

/// xi = 1/2: the order of the nodes does not matter [13, 17, 33].
struct Invariant : Family<FrameHalfway, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "invariant";
  static constexpr const char* stands_for = "paper \"invariant\", MBDyn invariant forms";
  static constexpr Facts facts{.loop_slope = 4};
};

/// Any real xi [10-12, 19, 30]. The facts are those of xi = 0.3, at which verify probes it.
struct Intrinsic : Family<FrameWeighted, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "intrinsic";
  static constexpr const char* stands_for = "the paper's general form, any xi";
  static constexpr double kProbeXi = 0.3;
  static constexpr Facts facts{.node_order_angular = {0.02, 1},
                               .node_order_linear = {0.04, 5},
                               .loop_slope = 3,
                               .alpha = kProbeXi};
  explicit Intrinsic(double xi = kProbeXi) : Family{FrameWeighted{xi}} {}
};

}  // namespace halfway
