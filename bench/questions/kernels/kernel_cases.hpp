// Residual and tangent of one formulation's kernel, every kind; included by the generated units.
#pragma once

#include "bench/questions/kernels/kernel_case.hpp"

namespace halfway::bench {

template <class F>
Cases kernel_cases() {
  Cases cases;
  if constexpr (kernel::kHasKernel<F>) {
    const auto add = [&]<Kind kind>(std::integral_constant<Kind, kind>) {
      const auto in = std::make_shared<const Inputs>(inputs_of<F>(kind));
      cases.push_back(kernel_case<F, kind, false>(in));
      cases.push_back(kernel_case<F, kind, true>(in));
    };
    add(std::integral_constant<Kind, Kind::angular>{});
    add(std::integral_constant<Kind, Kind::linear>{});
    add(std::integral_constant<Kind, Kind::linear_angular>{});
  }
  return cases;
}

}  // namespace halfway::bench
