// The loops of which the peaks are made: one unit per instruction set, each compiled for it. No
// standard header here: an inline function compiled for AVX-512 must not become the program's.
#pragma once

namespace halfway::bench {

inline constexpr int kAccumulators = 12;  ///< independent: latency 4, two units need 8; SSE2 has 16 registers

/// One instruction set of the peak loops. Both loops run only where the processor has it.
struct PeakLoops {
  int double_lanes, float_lanes;
  /// acc = acc * factor + term, `steps` times in each of kAccumulators packs, the j-th starting from j;
  /// the sum of all lanes.
  double (*doubles)(long steps, double factor, double term);
  double (*floats)(long steps, float factor, float term);
  /// Sum of `count` doubles, a multiple of 8 kAccumulators, on a boundary of 64 bytes.
  double (*sum)(const double* begin, long count);
};

extern const PeakLoops kScalarLoops, kSse2Loops, kAvx2Loops, kAvx512Loops;

}  // namespace halfway::bench
