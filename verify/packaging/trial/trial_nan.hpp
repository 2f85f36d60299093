// A saboteur as a header: its rotational strain is NaN, and with it every moment.
#pragma once

#include "halfway/joint/family.hpp"

#include <limits>

namespace halfway {

struct NanMeasure : RotationVectorMeasure {
  template <class T>
  static Vec3<T> strain(const RelativeMotion<T>&) {
    return Vec3<T>::Constant(T(std::numeric_limits<double>::quiet_NaN()));
  }
};

struct TrialNan : Family<FrameHalfway, NanMeasure, Projected> {
  static constexpr const char* name = "trial_nan";
  static constexpr const char* stands_for = "a saboteur tried out of tree: moments are NaN";
  static constexpr Facts facts{};
};

}  // namespace halfway
