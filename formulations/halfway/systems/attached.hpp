// Attached joints: the law refers to the frame of one node (xi = 0 or 1).
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

/// The paper's "ground" [16, 31]; MBDyn's deformable hinge, displacement joint and joint.
struct AttachedA : Family<FrameA, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "attached_a";
  static constexpr const char* stands_for =
      "paper \"ground\", MBDyn deformable joints, MuJoCo ball and cable";
  static constexpr Facts facts{
      .node_order = {.angular = near(0.607), .linear = near(2.13), .linear_angular = near(1.23)},
      .symmetry = {.angular = near(0.739), .linear_angular = near(0.512)},
      .loop_work = {.angular = near(0.151), .linear_angular = near(0.136)},
      .loop_slope = 3,
      .clamped_energy = near(0.243),
      .alpha = 0};
};

/// The paper's "node": the same joint with its nodes exchanged.
struct AttachedB : Family<FrameB, RotationVectorMeasure, Projected> {
  static constexpr const char* name = "attached_b";
  static constexpr const char* stands_for = "paper \"node\", DART BallJoint";
  static constexpr Facts facts{
      .node_order = {.angular = near(0.607), .linear = near(0.776), .linear_angular = near(2.19)},
      .symmetry = {.angular = near(0.682), .linear_angular = near(0.471)},
      .loop_work = {.angular = near(0.19), .linear_angular = near(0.173)},
      .loop_slope = 3,
      .clamped_energy = near(0.3636),
      .alpha = 1};
};

}  // namespace halfway
