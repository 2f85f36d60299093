// Flops of the kernel cases, with ends as those are timed.
#pragma once

#include "bench/kernels/counted_flops.hpp"

namespace halfway::bench {

/// 0 where there is no kernel.
template <class F, Kind kind, bool with_tangent, class Accuracy = kernel::Accuracy<>>
double kernel_flops(const Inputs& in) {
  if constexpr (!kernel::kHasKernel<F>)
    return 0;
  else
    return counted_flops<F, kind, with_tangent, Accuracy, kernel::Ends<reference::Counting>>(in);
}

}  // namespace halfway::bench
