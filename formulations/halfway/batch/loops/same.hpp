// Kernels that do not differ for a kind of joint are compiled once.
#pragma once

#include "halfway/kernels/joint.hpp"

namespace halfway::batch::detail {

/// The kernel that serves K for this kind.
template <class K, Kind kind>
struct Served {
  using By = K;
};
/// A force alone sees the frame, not the measure.
template <class Translation, class Measure, class Transport>
requires(
    Translation::kFrame) struct Served<kernel::FamilyKernel<Translation, Measure, Transport>, Kind::linear> {
  using By = kernel::FamilyKernel<Translation, RotationVectorMeasure, Projected>;
};
template <class Measure>
struct Served<kernel::FamilyKernel<Se3Translation, Measure, Conjugate>, Kind::angular> {
  using By = kernel::FamilyKernel<FrameHalfway, Measure, Conjugate>;
};
/// One potential of the rotation.
template <>
struct Served<kernel::FamilyKernel<FrameHalfway, QuaternionMeasure, Conjugate>, Kind::angular> {
  using By = kernel::FasseKernel;
};
/// A rod without rotations is none, and its forces are none's concern where there are rotations alone.
template <class Rod>
struct Served<kernel::RodKernel<Rod>, Kind::linear> {
  using By = typename Served<typename kernel::RodKernel<Rod>::Half, Kind::linear>::By;
};
template <>
struct Served<kernel::RodKernel<kernel::Slender>, Kind::angular> {
  using By = kernel::RodKernel<kernel::AsSeen>;
};
template <>
struct Served<kernel::ExudynKernel, Kind::angular> {
  using By = kernel::ExudynKernel::Half;
};
template <>
struct Served<kernel::MbdynJointInvKernel, Kind::angular> {
  using By = kernel::MbdynJointInvKernel::AtA;
};
/// -law(-e) is law(e) for the laws of a batch: linear, and odd polynomials.
template <>
struct Served<kernel::ChronoKernel, Kind::angular> {
  using By = kernel::ChronoKernel::AtB;
};

/// Which numbers of the tangent are kept: all (81 but of angular joints), or what expand() makes them of.
enum class Kept { all, general, conservative };

/// The fewest that tell the tangent: objectivity tells the rest of a moment's, and with balance and a
/// symmetric derivative of the force by the position that of a force's.
template <class K, Kind kind>
inline constexpr Kept kPacked = kind == Kind::angular ||
                                        (kernel::kSymmetricForce<K> && !kernel::kConservative<K, kind>)
                                    ? Kept::general
                                : kernel::kSymmetricForce<K> ? Kept::conservative
                                                             : Kept::all;

template <class F>
using KernelType = decltype(kernel::KernelOf<F>::make(*static_cast<const F*>(nullptr)));

}  // namespace halfway::batch::detail
