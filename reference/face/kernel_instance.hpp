// The kernel joint of a spec, and the registry entry of one formulation's kernel.
#pragma once

#include "halfway/kernels/compensated.hpp"
#include "reference/face/kernel_convert.hpp"
#include "reference/face/make_formulation.hpp"

namespace halfway::reference {

template <class F, Kind kind, class T, class E = kernel::Ends<T>>
auto make_kernel_joint(const F& formulation, const JointSpec& spec) {
  const auto law = plain_law<kind, T>(std::get<LinearSpec>(spec.law).matrix);
  const auto made = kernel::KernelOf<F>::make(formulation);
  using K = std::remove_const_t<decltype(made)>;
  using L = std::remove_const_t<decltype(law)>;
  kernel::KernelJoint<kind, K, L, E> joint{made, law};
  if constexpr (!std::is_same_v<E, kernel::NoEnds>) joint.ends = {plain_end<T>(spec.a), plain_end<T>(spec.b)};
  return joint;
}

template <class F, class T, class Accuracy, class E = kernel::Ends<T>>
AngularLoads<T> kernel_angular(const JointSpec& spec, const QuaternionPose<T>& a, const QuaternionPose<T>& b,
                               bool with_tangent) {
  const auto joint = make_kernel_joint<F, Kind::angular, T, E>(make_formulation<F>(spec), spec);
  const auto qa = plain(a).q, qb = plain(b).q;
  if constexpr (std::is_same_v<T, double>) {
    if (!with_tangent) return eigen(kernel::loads<false, Accuracy>(joint, qa, qb));
  }
  return eigen(kernel::loads<true, Accuracy>(joint, qa, qb));
}

template <class F, Kind kind, class T>
NodeLoads<T> kernel_point(const JointSpec& spec, const QuaternionPose<T>& a, const QuaternionPose<T>& b,
                          bool with_tangent) {
  const auto joint = make_kernel_joint<F, kind, T>(make_formulation<F>(spec), spec);
  if constexpr (std::is_same_v<T, double>) {
    if (!with_tangent) return eigen(kernel::loads<false>(joint, plain(a), plain(b)));
  }
  return eigen(kernel::loads<true>(joint, plain(a), plain(b)));
}

template <class F, class T>
KernelEvaluators<T> kernel_evaluators() {
  return {&kernel_angular<F, T, kernel::Accuracy<>>, [](const JointSpec& spec, const QuaternionPose<T>& a,
                                                        const QuaternionPose<T>& b, bool with_tangent) {
            return spec.kind == Kind::linear
                       ? kernel_point<F, Kind::linear, T>(spec, a, b, with_tangent)
                       : kernel_point<F, Kind::linear_angular, T>(spec, a, b, with_tangent);
          }};
}

template <class F>
KernelEntry make_kernel_entry() {
  if constexpr (!kernel::kHasKernel<F>) {
    return {};
  } else {
    using Compensated = kernel::Accuracy<kernel::ExactAngle, kernel::Compensated>;
    return {kernel_evaluators<F, double>(),
            {&kernel_angular<F, double, Compensated, kernel::NoEnds>, nullptr},
            kernel_evaluators<F, float>()};
  }
}

}  // namespace halfway::reference
