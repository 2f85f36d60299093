// The parts of a joint that do not depend on its formulation, compiled once for each scalar of the
// registry (instantiations.cpp.in) instead of once more in every formulation's unit.
#pragma once

#include "reference/face/registry.hpp"

// clang-format off
#define HALFWAY_INSTANTIATE(prefix, T)                                                                         \
  prefix template class reference::AnyLaw<T, 3>;                                                               \
  prefix template class reference::AnyLaw<T, 6>;                                                               \
  prefix template struct Isotropic<T>;                                                                         \
  prefix template Stumpff<T> stumpff<T>(const T&);                                                             \
  prefix template Jet<T> tangent_quotient<T>(const T&);                                                        \
  prefix template Jet<T> kappa<T>(const T&);                                                                   \
  prefix template Mat3<T> skew<T>(const Vec3<T>&);                                                             \
  prefix template Isotropic<T> so3::exp_isotropic<T>(const T&, const T&);                                      \
  prefix template Mat3<T> so3::exp<T>(const Vec3<T>&);                                                         \
  prefix template Mat3<T> so3::gamma<T>(const Vec3<T>&);                                                       \
  prefix template Mat3<T> so3::gamma_inverse<T>(const Vec3<T>&);                                               \
  prefix template so3::Quaternion<T> so3::quaternion<T>(const Mat3<T>&);                                       \
  prefix template Mat3<T> so3::matrix<T>(const so3::Quaternion<T>&);                                           \
  prefix template Vec3<T> so3::log<T>(const so3::Quaternion<T>&);                                              \
  prefix template so3::Quaternion<T> so3::half<T>(const so3::Quaternion<T>&);                                  \
  prefix template RelativeMotion<T> relative_motion<T>(const Mat3<T>&, const Vec3<T>&);                        \
  prefix template RelativeMotion<T> angular_motion<T>(const JointEnd<T>&, const JointEnd<T>&, const Pose<T>&,  \
                                                      const Pose<T>&);                                         \
  prefix template RelativeMotion<T> full_motion<T>(const JointEnd<T>&, const JointEnd<T>&, const Pose<T>&,     \
                                                   const Pose<T>&);                                            \
  prefix template Mat3<T> spin_derivative<T>(const Vec3<T>&, const Vec3<T>&, const Mat3<T>&);                  \
  prefix template Mat3<T> FrameHalfway::spin<T>(const RelativeMotion<T>&);                                     \
  prefix template Mat3<T> FrameHalfway::spin_transposed_rate<T>(const RelativeMotion<T>&, const Vec3<T>&);     \
  prefix template void balance_moment<T>(const RelativeMotion<T>&, PointResponse<T>&);                         \
  prefix template PointResponse<T> force_response<true, T>(const RelativeMotion<T>&, const Isotropic<T>&,      \
                                                           const Vec3<T>&, const Mat3<T>&);                    \
  prefix template PointResponse<T> force_response<false, T>(const RelativeMotion<T>&, const Isotropic<T>&,     \
                                                            const Vec3<T>&, const Mat3<T>&);                   \
  prefix template RelativeMotion<T> linear_motion<T>(const JointEnd<T>&, const JointEnd<T>&, const Pose<T>&,   \
                                                     const Pose<T>&);                                          \
  prefix template StrainRates<T> strain_rates_of<T>(const RelativeMotion<T>&, const Isotropic<T>&);            \
  prefix template PointResponse<T> fixed_force_response<true, T>(const RelativeMotion<T>&, const Vec3<T>&,     \
                                                                 const Mat3<T>&);                              \
  prefix template PointResponse<T> fixed_force_response<false, T>(const RelativeMotion<T>&, const Vec3<T>&,    \
                                                                  const Mat3<T>&);                             \
  prefix template PointResponse<T> frame_force_response<T>(const RelativeMotion<T>&, const Mat3<T>&,           \
                                                           const Mat3<T>&, const Vec3<T>&);                    \
  prefix template void add_moment<true, T>(const RelativeMotion<T>&, const LawResponse<T, 6>&,                 \
                                           const MomentMap<T>&, const StrainRates<T>&, PointResponse<T>&);     \
  prefix template void add_moment<false, T>(const RelativeMotion<T>&, const LawResponse<T, 6>&,                \
                                            const MomentMap<T>&, const StrainRates<T>&, PointResponse<T>&);    \
  prefix template NodeLoads<T> at_nodes<true, T>(const PointResponse<T>&, const RelativeMotion<T>&,            \
                                                 const JointEnd<T>&, const JointEnd<T>&, const Pose<T>&,       \
                                                 const Pose<T>&);                                              \
  prefix template NodeLoads<T> at_nodes<false, T>(const PointResponse<T>&, const RelativeMotion<T>&,           \
                                                  const JointEnd<T>&, const JointEnd<T>&, const Pose<T>&,      \
                                                  const Pose<T>&);
// clang-format on

namespace halfway {
HALFWAY_INSTANTIATE(extern, double)
HALFWAY_INSTANTIATE(extern, reference::Real50)
HALFWAY_INSTANTIATE(extern, reference::Dual<reference::Real50>)
}  // namespace halfway
