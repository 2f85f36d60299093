// A saboteur as a header: the logarithm of R^T for that of R, its rate as it was.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

struct TransposedMeasure : RotationVectorMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>& m) {
    return -m.theta;
  }
};

struct TrialTransposed : Family<FrameHalfway, TransposedMeasure, Projected> {
  static constexpr const char* name = "trial_transposed";
  static constexpr const char* stands_for =
      "a saboteur tried out of tree: strains of the transposed rotation";
  static constexpr Facts facts{};
};

}  // namespace halfway
