// Beyond the paper: what a uniform rod does, to fourth order in its energy (rod_law.hpp).
#pragma once

#include "halfway/systems/potentials.hpp"
#include "halfway/systems/rod_law.hpp"
#include "halfway/systems/rod_radius.hpp"

namespace halfway {

/// `potential` with laws that are replaced by a rod's. A linear joint has no rotation stiffness, hence no
/// rod: it is potential's.
/// @tparam Rod  offers law(law), of six strains
template <class Rod>
struct RodJoint {
  static constexpr bool kLinearWithoutRotation = Potential::kLinearWithoutRotation;
  static constexpr bool has_potential(Kind) { return true; }
  /// Convex below this |theta|, rad, for a law of that stiffness at no strain; refused beyond by what solves.
  template <class Matrix>
  static double convex_radius(const Matrix& K) {
    return rod_convex_radius(K);
  }

  template <Kind kind, class T>
  Strain<T, kind> strain(const RelativeMotion<T>& m) const {
    return Potential{}.strain<kind>(m);
  }
  template <Kind kind, class T, ElasticLaw<T, strain_count(kind)> L>
  T energy(const RelativeMotion<T>& m, const L& law) const {
    return rod_law<kind, T>(law).energy(strain<kind>(m));
  }
  template <bool with_tangent, class T, Law<T, 3> L>
  AngularResponse<T> angular(const RelativeMotion<T>& m, const L& law) const {
    return Potential{}.angular<with_tangent>(m, rod_law<Kind::angular, T>(law));
  }
  template <Kind kind, bool with_tangent, class T, Law<T, strain_count(kind)> L>
  PointResponse<T> point(const RelativeMotion<T>& m, const L& law) const {
    return Potential{}.point<kind, with_tangent>(m, rod_law<kind, T>(law));
  }

 private:
  template <Kind kind, class T, class L>
  auto rod_law(const L& law) const {
    if constexpr (kind == Kind::linear)
      return law;
    else if constexpr (kind == Kind::angular)
      return RodLaw<T, 3, L>{law};
    else
      return static_cast<const Rod&>(*this).template law<T>(law);
  }
};

/// The energy of a uniform rod under a pure moment, right to fourth order; K needs an inverse.
struct Rod4 : RodJoint<Rod4> {
  static constexpr const char* name = "rod4";
  static constexpr const char* stands_for = "uniform rod under end moments, fourth order, beyond the paper";
  static constexpr Facts facts{};

  template <class T, class L>
  RodLaw<T, 6, L> law(const L& law) const {
    return {law};
  }
};

/// That of a slender, straight, uniform rod under forces too, with the joint at mid-length.
struct Rod34 : RodJoint<Rod34> {
  static constexpr const char* name = "rod34";
  static constexpr const char* stands_for =
      "slender straight rod under end loads, fourth order, beyond the paper";
  static constexpr double kProbeLength = 0.7;
  static constexpr int kProbeAxis = -2;
  static constexpr Facts facts{};

  Parameters rod;
  /// @param length  m, > 0    @param axis  1, 2, 3 or -1, -2, -3, see Parameters
  explicit Rod34(double length, int axis = 1) : rod{.length = length, .axis = axis} {}

  template <class T, class L>
  RodLaw<T, 6, SlenderLaw<T, L>> law(const L& law) const {
    return {SlenderLaw<T, L>(law, rod)};
  }
};

}  // namespace halfway
