// The instruction sets of this processor.
#pragma once

#include "bench/peak/peak_loop.hpp"

#include <vector>

namespace halfway::bench {

struct Isa {
  const char* name;  ///< scalar, sse2, avx2, avx2vl, avx512
  const PeakLoops* loops;
};

/// Those that can run here, narrowest first.
inline std::vector<Isa> available_isas() {
  std::vector<Isa> out{{"scalar", &kScalarLoops}};
#ifdef __x86_64__
  out.push_back({"sse2", &kSse2Loops});
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) out.push_back({"avx2", &kAvx2Loops});
  if (__builtin_cpu_supports("avx512vl")) out.push_back({"avx2vl", &kAvx2Loops});  // as wide, more registers
  if (__builtin_cpu_supports("avx512f")) out.push_back({"avx512", &kAvx512Loops});
#endif
  return out;
}

}  // namespace halfway::bench
