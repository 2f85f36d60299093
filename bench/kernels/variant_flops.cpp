// Flops of the variants, in a unit that nobody times.
#include "bench/kernels/kernel_flops.hpp"

#include "formulations/systems/intrinsic.hpp"

namespace halfway::bench {

#define HALFWAY_FLOPS(...)                                                                      \
  template double kernel_flops<Invariant, Kind::angular, false, kernel::Accuracy<__VA_ARGS__>>( \
      const Inputs&);                                                                           \
  template double kernel_flops<Invariant, Kind::angular, true, kernel::Accuracy<__VA_ARGS__>>(const Inputs&);
HALFWAY_FLOPS(kernel::SmallAngle<1>)
HALFWAY_FLOPS(kernel::SmallAngle<2>)
HALFWAY_FLOPS(kernel::SmallAngle<3>)
HALFWAY_FLOPS(kernel::PolynomialAngle<4>)
HALFWAY_FLOPS(kernel::PolynomialAngle<8>)
HALFWAY_FLOPS(kernel::PolynomialAngle<12>)
HALFWAY_FLOPS(kernel::PolynomialAngle<18>)
#undef HALFWAY_FLOPS

}  // namespace halfway::bench
