// What a kernel asks first: how much of the angle, and the law's answer in global axes.
#pragma once

#include "halfway/kernels/euler.hpp"
#include "halfway/kernels/laws.hpp"

namespace halfway::kernel {

/// How much of the angle's jet a measure needs.
template <class Measure>
constexpr int jet_order(bool rate, bool rate_of_rate) {
  if constexpr (kVectorial<Measure>)
    return MeasureKernel<Measure>::kJet[rate_of_rate ? 2 : rate ? 1 : 0];
  else
    return -1;
}
template <class Angle, int order, class T>
HALFWAY_INLINE AngleJet<T> jet_at(const Relative<T>& r) {
  if constexpr (order < 0)
    return {};
  else
    return Angle::template jet<order>(HalfAngle<T>{r.t, r.w, r.iw});
}

/// The law's answer in global axes: force in frame F, moment in frame H.
template <class T>
struct Response {
  V3<T> f, m;
  Stiffness6<T> K;
};

/// @param local  strain as the law sees it, in frames F and H
/// @param global  the same vectors in global axes: a linear law need not be asked before it is turned
template <bool with_tangent, class T, class L>
HALFWAY_INLINE Response<T> respond(const L& law, const M3<T>& F, const M3<T>& H, const Pair<T>& local,
                                   const Pair<T>& global) {
  Response<T> r;
  if constexpr (with_tangent) {
    const Stiffness6<T> k = law.stiffness(local);
    r.K = {turned(F, k.ff), turned(F, k.fm, H), turned(H, k.mm)};
  }
  if constexpr (with_tangent && L::kLinear) {
    r.f = r.K.ff * global.f + r.K.fm * global.m;
    r.m = global.f * r.K.fm + r.K.mm * global.m;
  } else {
    const Pair<T> stress = law.stress(local);
    r.f = F * stress.f;
    r.m = H * stress.m;
  }
  return r;
}
template <bool with_tangent, class T, class L>
HALFWAY_INLINE void respond(const L& law, const M3<T>& F, const V3<T>& local, const V3<T>& global,
                            V3<T>& stress, S3<T>& K) {
  if constexpr (with_tangent) K = turned(F, law.stiffness(local));
  if constexpr (with_tangent && L::kLinear)
    stress = K * global;
  else
    stress = F * law.stress(local);
}

}  // namespace halfway::kernel
