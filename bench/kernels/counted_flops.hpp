// Flops of a kernel, counted by running it; compiled in units that nobody times, like flops.hpp.
#pragma once

#include "bench/kernels/kernel_joint.hpp"
#include "reference/counting.hpp"

namespace halfway::bench {

/// Of one evaluation: a kernel has no branches, one pose tells all.
template <class F, Kind kind, bool with_tangent, class Accuracy, class E>
double counted_flops(const Inputs& in) {
  using reference::Counting;
  const auto joint = static_kernel_joint<F, kind, Counting, E>(in.spec);
  const auto cast = [](const reference::QuaternionPose<double>& p) {
    return reference::plain(reference::QuaternionPose<Counting>{p.x.cast<Counting>(), p.q.cast<Counting>()});
  };
  const auto a = cast(in.qa.front()), b = cast(in.qb.front());
  const auto count = reference::counted([&] {
    if constexpr (kind == Kind::angular)
      (void)kernel::loads<with_tangent, Accuracy>(joint, a.q, b.q);
    else
      (void)kernel::loads<with_tangent, Accuracy>(joint, a, b);
  });
  return double(count.flops());
}

}  // namespace halfway::bench
