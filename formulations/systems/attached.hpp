// Attached joints: the law refers to the frame of one node (xi = 0 or 1).
#pragma once

#include "formulations/family.hpp"

namespace halfway {

/// The paper's "ground" [16, 31]; MBDyn's deformable hinge, displacement joint and joint.
struct AttachedA : Family<FrameA, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "attached_a";
  static constexpr const char* stands_for = "paper \"ground\", MBDyn deformable joints";
  static constexpr Facts facts{.node_order_angular = {0.05, 2},
                               .node_order_linear = {0.1, 10},
                               .loop_slope = 3,
                               .alpha = 0};
};

/// The paper's "node": the same joint with its nodes exchanged.
struct AttachedB : Family<FrameB, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "attached_b";
  static constexpr const char* stands_for = "paper \"node\"";
  static constexpr Facts facts{.node_order_angular = {0.05, 2},
                               .node_order_linear = {0.1, 10},
                               .loop_slope = 3,
                               .alpha = 1};
};

}  // namespace halfway
