// The processor's own limit, measured in this process: multiply-adds on registers, nothing else.
#pragma once

#include <string>
#include <vector>

namespace halfway::bench {

struct Peak {
  std::string isa;          ///< scalar and sse2 (a product and a sum), avx2 and avx512 (fused)
  std::string precision;    ///< double, float
  double flops_per_ns = 0;  ///< of one core; CPU time
};
using Peaks = std::vector<Peak>;

/// Of every instruction set that the processor has; some 0.3 s. Throws std::runtime_error when a loop
/// does not return the number that it must.
Peaks measured_peaks();

/// The larger of two measurements of the same machine: it is a limit.
Peaks larger(Peaks a, const Peaks& b);

}  // namespace halfway::bench
