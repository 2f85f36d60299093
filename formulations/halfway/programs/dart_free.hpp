// DART FreeJoint with spring stiffness.
#pragma once

#include "halfway/programs/composed.hpp"

namespace halfway::programs {

/// The coordinates are (log R, P_a^T d), but their forces are taken along the axes of b. Even with one
/// stiffness the force is turned away from d by the whole relative rotation: work round a loop of six
/// freedoms.
struct DartFree : BySprings<DartFree> {
  static constexpr const char* name = "dart_free";
  static constexpr const char* stands_for = "DART FreeJoint spring";
  static constexpr ProgramFacts facts{
      .source = "DART 6.12.1, 5e-15", .isotropic_conservative = true, .tensorial = true};

  template <class T>
  static Strain<T, Kind::linear_angular> strain(const RelativeMotion<T>& m) {
    Strain<T, Kind::linear_angular> e;
    e << m.p, m.theta;
    return e;
  }

  template <class T>
  static ProgramLoads<T> of_stress(const RelativeMotion<T>& m, const Vec3<T>& force, const Vec3<T>& moment) {
    return AtB::loads<T>(m.p, m.R * force, m.R * moment);
  }
};

}  // namespace halfway::programs
