// Abaqus/Standard JOINTC, linear parametrization sin(phi) n, appendix A [52-56].
#pragma once

#include "formulations/family.hpp"

namespace halfway {

struct Jointc : Family<FrameA, LinearMeasure, Conjugate> {
  static constexpr const char* name = "jointc";
  static constexpr const char* stands_for = "Abaqus/Standard JOINTC";
  static constexpr Facts facts{.node_order_linear = {0.1, 10}};
};

}  // namespace halfway
