// The kernels of rod4 and rod34: potential's, asked with laws that ask the joint's own
// (halfway/systems/rod_law.hpp has their equations).
#pragma once

#include "halfway/kernels/dual.hpp"
#include "halfway/kernels/family.hpp"
#include "halfway/kernels/slender.hpp"
#include "halfway/systems/rod.hpp"

namespace halfway::kernel {

/// Of a symmetric matrix, by its cofactors.
template <class T>
HALFWAY_INLINE S3<T> inverse(const S3<T>& k) {
  const T xx = k.yy * k.zz - k.yz * k.yz, xy = k.xz * k.yz - k.xy * k.zz, xz = k.xy * k.yz - k.xz * k.yy;
  const T s = T(1) / (k.xx * xx + k.xy * xy + k.xz * xz);
  return {s * xx,
          s * xy,
          s * xz,
          s * (k.xx * k.zz - k.xz * k.xz),
          s * (k.xy * k.xz - k.xx * k.yz),
          s * (k.xx * k.yy - k.xy * k.xy)};
}

/// What the fourth order has at one rotation vector.
template <class T>
struct RodTerms {
  S3<T> K, compliance;
  V3<T> theta, w, v;

  HALFWAY_INLINE RodTerms(const S3<T>& stiffness, const V3<T>& rotation)
      : K(stiffness),
        compliance(inverse(K)),
        theta(rotation),
        w(K * theta),
        v(compliance * cross(w, theta)) {}

  HALFWAY_INLINE V3<T> gradient() const { return T(1.0 / 12) * (cross(w, v) - K * cross(theta, v)); }
  HALFWAY_INLINE S3<T> hessian() const {
    const M3<T> B = plus_skew(-skew_times(theta, full(K)), w), turn = skew_times(v, full(K));
    return upper_triangle(T(-1.0 / 12) * (full(turned(transposed(B), compliance)) + turn + transposed(turn)));
  }
};

/// A law with the rod's fourth order.
template <class L>
struct RodLaw {
  static constexpr bool kLinear = false;
  L law;

  template <class T>
  HALFWAY_INLINE V3<T> stress(const V3<T>& e) const {
    return law.stress(e) + RodTerms<T>(law.stiffness(zero3<T>()), e).gradient();
  }
  template <class T>
  HALFWAY_INLINE S3<T> stiffness(const V3<T>& e) const {
    return law.stiffness(e) + RodTerms<T>(law.stiffness(zero3<T>()), e).hessian();
  }
  template <class T>
  HALFWAY_INLINE Pair<T> stress(const Pair<T>& e) const {
    const Pair<T> s = law.stress(e);
    return {s.f, s.m + terms(e).gradient()};
  }
  template <class T>
  HALFWAY_INLINE Stiffness6<T> stiffness(const Pair<T>& e) const {
    const Stiffness6<T> k = law.stiffness(e);
    return {k.ff, k.fm, k.mm + terms(e).hessian()};
  }

 private:
  template <class T>
  HALFWAY_INLINE RodTerms<T> terms(const Pair<T>& e) const {
    return {law.stiffness(Pair<T>{zero3<T>(), zero3<T>()}).mm, e.m};
  }
};

/// Of dual numbers: the derivative of the whole is its stiffness.
template <class L>
struct RodAlong {
  static constexpr bool kLinear = false;
  L rod;
  template <class E>
  HALFWAY_INLINE E stress(const E& e) const {
    return LawAlong<L>{rod}.stress(e);
  }
};

/// @tparam Rod  makes the rod's law of six strains of the joint's
template <class Rod>
struct RodKernel {
  Rod rod{};

  using Half = FamilyKernel<FrameHalfway, RotationVectorMeasure, Conjugate>;
  static constexpr bool kBalanced = true, kSymmetricForce = true;
  template <Kind>
  static constexpr bool kConservative = true;

  template <class Angle, bool with_tangent, class T, class L>
  HALFWAY_INLINE MomentLoads<T> angular(const Relative<T>& r, const L& law) const {
    return Half{}.template angular<Angle, with_tangent>(r, rod_law<Kind::angular>(law));
  }
  template <class Angle, Kind kind, bool with_tangent, class T, class L>
  HALFWAY_INLINE PointLoads<T> point(const Relative<T>& r, const V3<T>& d, const L& law) const {
    return Half{}.template point<Angle, kind, with_tangent>(r, d, rod_law<kind>(law));
  }
  template <class Angle, Kind kind, bool with_tangent, class T, class L, class Out>
  HALFWAY_INLINE void at_nodes(const Relative<T>& r, const V3<T>& d, const L& law, Out& out) const {
    Half{}.template at_nodes<Angle, kind, with_tangent>(r, d, rod_law<kind>(law), out);
  }

 private:
  template <Kind kind, class L>
  HALFWAY_INLINE auto rod_law(const L& law) const {
    if constexpr (kind == Kind::linear)
      return law;
    else if constexpr (kind == Kind::angular)
      return RodLaw<L>{law};
    else
      return rod.law(law);
  }
  template <Kind kind, class L>
  HALFWAY_INLINE auto rod_law(const LawAlong<L>& along) const {
    if constexpr (kind == Kind::linear) {
      return along;
    } else {
      const auto whole = rod_law<kind>(along.law);
      return RodAlong<std::remove_const_t<decltype(whole)>>{whole};
    }
  }
};

/// rod4: strains as they are.
struct AsSeen {
  template <class L>
  HALFWAY_INLINE RodLaw<L> law(const L& law) const {
    return {law};
  }
};
/// rod34: those of a slender rod.
struct Slender {
  Parameters parameters{};
  template <class L>
  HALFWAY_INLINE RodLaw<SlenderLaw<L>> law(const L& law) const {
    return {{law, parameters}};
  }
};

}  // namespace halfway::kernel
