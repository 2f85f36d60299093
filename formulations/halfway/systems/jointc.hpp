// Abaqus/Standard JOINTC, linear parametrization sin(phi) n, appendix A [52-56].
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

struct Jointc : Family<FrameA, LinearMeasure, Conjugate> {
  static constexpr const char* name = "jointc";
  static constexpr const char* stands_for = "Abaqus/Standard JOINTC";
  static constexpr Facts facts{.node_order = {.linear = near(2.13), .linear_angular = near(1.27)}};
};

}  // namespace halfway
