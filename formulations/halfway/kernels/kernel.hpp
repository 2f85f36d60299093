// The kernel of each formulation, if it has one: KernelOf<F>::make(formulation).
//
// A formulation of the family has one by itself if its measure has (measures.hpp, euler.hpp); another
// declares it (fasse.hpp, rod.hpp, peers.hpp). What has none is evaluated by its readable transcription alone
// (joint.hpp), which stays the reference of both.
#pragma once

#include "halfway/kernels/fasse.hpp"
#include "halfway/kernels/peers.hpp"
#include "halfway/kernels/rod.hpp"

namespace halfway::kernel {

namespace detail {
template <class Translation, class Measure, class Transport>
requires(kVectorial<Measure> || kEuler<Measure>) FamilyKernel<Translation, Measure, Transport> family_kernel(
    const Family<Translation, Measure, Transport>& f) {
  return {f.translation};
}
template <class F>
constexpr bool in_family() {
  return requires(const F& f) { detail::family_kernel(f); };
}
}  // namespace detail

template <class F>
struct KernelOf {};

template <class F>
requires(detail::in_family<F>()) struct KernelOf<F> {
  static auto make(const F& formulation) { return detail::family_kernel(formulation); }
};
template <>
struct KernelOf<Fasse> {
  static FasseKernel make(const Fasse&) { return {}; }
};
template <>
struct KernelOf<Rod4> {
  static RodKernel<AsSeen> make(const Rod4&) { return {}; }
};
template <>
struct KernelOf<Rod34> {
  static RodKernel<Slender> make(const Rod34& rod34) { return {{rod34.rod}}; }
};
template <>
struct KernelOf<ChronoBody> {
  static ChronoKernel make(const ChronoBody&) { return {}; }
};
template <>
struct KernelOf<DrakeRpy> {
  static DrakeKernel make(const DrakeRpy&) { return {}; }
};
template <>
struct KernelOf<ExudynIntrinsic> {
  static ExudynKernel make(const ExudynIntrinsic&) { return {}; }
};
template <>
struct KernelOf<MbdynJointInv> {
  static MbdynJointInvKernel make(const MbdynJointInv&) { return {}; }
};

template <class F>
inline constexpr bool kHasKernel = requires(const F& f) {
  KernelOf<F>::make(f);
};

}  // namespace halfway::kernel
