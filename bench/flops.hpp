// Flops of a joint's evaluation, counted by running it. In units of their own, because the counting
// scalar doubles the compile time of what it meets and nothing here is timed.
#pragma once

#include "bench/static_joint.hpp"
#include "reference/counting.hpp"
#include "reference/registry.hpp"

namespace halfway::bench {

/// Of one evaluation, the mean over every eighth pose: branches differ.
template <class F, Kind kind, bool with_tangent>
double flops(const Inputs& in) {
  using reference::Counting;
  const auto joint = make_joint<F, kind, Counting>(in.spec);
  constexpr int kStep = 8;
  const auto count = reference::counted([&] {
    for (int i = 0; i < kPoses; i += kStep) {
      (void)loads<with_tangent>(joint, reference::cast<Counting>(in.a[i]),
                                reference::cast<Counting>(in.b[i]));
    }
  });
  return double(count.flops()) * kStep / kPoses;
}

}  // namespace halfway::bench
