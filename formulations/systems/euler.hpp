// Joints on Euler angles: MSC/ADAMS FIELD as in Table 1, Simbody's and OpenSim's LinearBushing.
#pragma once

#include "formulations/family.hpp"

namespace halfway {

using Euler312 = EulerMeasure<2, 0, 1>;
using Euler123 = EulerMeasure<0, 1, 2>;
using Euler321 = EulerMeasure<2, 1, 0>;

/// Body 3-1-2 angles as a moment vector in the frame of node a; reproduces Table 1 (errata.md).
struct FieldA : Family<FrameA, Euler312, Projected> {
  static constexpr const char* name = "field_a";
  static constexpr const char* stands_for = "MSC/ADAMS FIELD, law at node a";
  static constexpr Facts facts{.node_order_angular = {0.05, 3},
                               .node_order_linear = {0.1, 10},
                               .loop_slope = 3,
                               .has_fingerprint = false};
};

struct FieldB : Family<FrameB, Euler312, Projected> {
  static constexpr const char* name = "field_b";
  static constexpr const char* stands_for = "MSC/ADAMS FIELD, law at node b";
  static constexpr Facts facts{.node_order_angular = {0.05, 3},
                               .node_order_linear = {0.1, 10},
                               .loop_slope = 3,
                               .has_fingerprint = false};
};

/// Body-fixed x-y-z angles and their conjugate moments, in the frame of node a.
struct SimbodyXyz : Family<FrameA, Euler123, Conjugate> {
  static constexpr const char* name = "simbody_xyz";
  static constexpr const char* stands_for = "Simbody / OpenSim LinearBushing";
  static constexpr Facts facts{.node_order_angular = {0.05, 3},
                               .node_order_linear = {0.1, 10},
                               .beta = -0.5};
};

}  // namespace halfway
