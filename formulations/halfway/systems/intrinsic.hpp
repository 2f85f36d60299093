// The paper's own forms: any frame xi, and the half-way one.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

/// xi = 1/2: the order of the nodes does not matter [13, 17, 33].
struct Invariant : Family<FrameHalfway, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "invariant";
  static constexpr const char* stands_for = "paper \"invariant\", MBDyn invariant forms";
  static constexpr Facts facts{.symmetry = {.angular = near(0.0558), .linear_angular = near(0.0381)},
                               .loop_work = {.angular = near(0.000307), .linear_angular = near(0.000574)},
                               .loop_slope = 4,
                               .clamped_energy = near(0.005231)};
};

/// Any real xi [10-12, 19, 30], which must be given: there is no usual one. The facts are those of xi = 0.3,
/// at which verify probes it.
struct Intrinsic : Family<FrameWeighted, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "intrinsic";
  static constexpr const char* stands_for = "the paper's general form, any xi";
  static constexpr double kProbeXi = 0.3;
  static constexpr Facts facts{
      .node_order = {.angular = near(0.248), .linear = near(0.571), .linear_angular = near(0.687)},
      .symmetry = {.angular = near(0.313), .linear_angular = near(0.202)},
      .loop_work = {.angular = near(0.0667), .linear_angular = near(0.0588)},
      .loop_slope = 3,
      .clamped_energy = near(0.1046),
      .alpha = kProbeXi};
  explicit Intrinsic(double xi) : Family{FrameWeighted{xi}} {}
};

}  // namespace halfway
