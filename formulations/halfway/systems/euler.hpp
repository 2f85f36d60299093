// Joints on Euler angles: MSC/ADAMS FIELD as in Table 1, Simbody's and OpenSim's LinearBushing.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

using Euler312 = EulerMeasure<2, 0, 1>;
using Euler123 = EulerMeasure<0, 1, 2>;
using Euler321 = EulerMeasure<2, 1, 0>;

/// Body 3-1-2 angles as a moment vector in the frame of node a; reproduces Table 1 (reference/data/paper,
/// errata).
struct FieldA : Family<FrameA, Euler312, Projected> {
  static constexpr const char* name = "field_a";
  static constexpr const char* stands_for = "MSC/ADAMS FIELD, law at node a";
  static constexpr Facts facts{
      .node_order = {.angular = near(0.818), .linear = near(2.13), .linear_angular = near(1.29)},
      .symmetry = {.angular = near(0.715), .linear_angular = near(0.549)},
      .loop_work = {.angular = near(0.131), .linear_angular = near(0.123)},
      .loop_slope = 3,
      .clamped_energy = near(0.7957),
      .has_fingerprint = false};
};

struct FieldB : Family<FrameB, Euler312, Projected> {
  static constexpr const char* name = "field_b";
  static constexpr const char* stands_for = "MSC/ADAMS FIELD, law at node b";
  static constexpr Facts facts{
      .node_order = {.angular = near(0.903), .linear = near(0.776), .linear_angular = near(1.23)},
      .symmetry = {.angular = near(0.941), .linear_angular = near(0.493)},
      .loop_work = {.angular = near(0.199), .linear_angular = near(0.204)},
      .loop_slope = 3,
      .clamped_energy = near(0.1742),
      .has_fingerprint = false};
};

/// Body-fixed x-y-z angles and their conjugate moments, in the frame of node a.
struct SimbodyXyz : Family<FrameA, Euler123, Conjugate> {
  static constexpr const char* name = "simbody_xyz";
  static constexpr const char* stands_for =
      "Simbody / OpenSim LinearBushing, Simscape Bushing, Abaqus CARTESIAN + CARDAN, MuJoCo hinge chains";
  static constexpr Facts facts{
      .node_order = {.angular = near(3.72), .linear = near(2.13), .linear_angular = near(1.09)},
      .beta = -0.5};
};

}  // namespace halfway
