// Beyond the paper: half-way joints that derive from a potential.
#pragma once

#include "halfway/joint/family.hpp"

namespace halfway {

/// nu = 4 tan(phi/4) n: node-order invariant, exactly conservative, regular to 2 pi; the only
/// conservative law of the form h(phi) R^ K n.
struct Conformal : Family<FrameHalfway, ConformalMeasure, Conjugate> {
  static constexpr const char* name = "conformal";
  static constexpr const char* stands_for = "Wiener-Milenkovic potential, beyond the paper";
  static constexpr Facts facts{};
};

/// U = 1/2 theta . K theta in the half-way frame.
struct Potential : Family<FrameHalfway, RotationVectorMeasure, Conjugate> {
  static constexpr const char* name = "potential";
  static constexpr const char* stands_for = "rotation vector potential, beyond the paper";
  static constexpr Facts facts{};
};

struct QuaternionJoint : Family<FrameHalfway, QuaternionMeasure, Conjugate> {
  static constexpr const char* name = "quaternion";
  static constexpr const char* stands_for =
      "2 sin(phi/2) n potential, beyond the paper; position-based rods, MuJoCo weld";
  static constexpr Facts facts{};
};

struct CayleyJoint : Family<FrameHalfway, CayleyMeasure, Conjugate> {
  static constexpr const char* name = "cayley";
  static constexpr const char* stands_for = "2 tan(phi/2) n potential, beyond the paper";
  static constexpr Facts facts{};
};

/// U = 1/2 xi . K xi with xi = log on SE(3): translation and rotation as one screw.
struct Helicoidal : Family<Se3Translation, RotationVectorMeasure, Conjugate> {
  static constexpr const char* name = "helicoidal";
  static constexpr const char* stands_for = "SE(3) potential, beyond the paper";
  static constexpr Facts facts{};
};

}  // namespace halfway
