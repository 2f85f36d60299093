// Compiled once per instruction set, with HALFWAY_LOOPS the name of its loops and HALFWAY_BYTES the
// width of its registers (0: scalar). Automatic vectorization is off: it would pack the scalar loop.
#include "bench/peak/peak_loop.hpp"

namespace halfway::bench {
namespace {

#if HALFWAY_BYTES == 0
using Doubles = double;
using Floats = float;
#else
typedef double Doubles __attribute__((vector_size(HALFWAY_BYTES)));
typedef float Floats __attribute__((vector_size(HALFWAY_BYTES)));
#endif

template <class V, class T>
constexpr int kLanes = int(sizeof(V) / sizeof(T));

template <class V, class T>
double lanes_sum(const V& v) {
  T lanes[kLanes<V, T>];
  __builtin_memcpy(lanes, &v, sizeof v);
  double sum = 0;
  for (const T& lane : lanes) sum += double(lane);
  return sum;
}

// Twelve names and not an array: registers, whatever the optimizer thinks of arrays.
template <class V, class T>
double multiply_add(long steps, T factor, T term) {
  const V m = V{} + factor, c = V{} + term;
  V a0 = V{} + T(0), a1 = V{} + T(1), a2 = V{} + T(2), a3 = V{} + T(3), a4 = V{} + T(4), a5 = V{} + T(5),
    a6 = V{} + T(6), a7 = V{} + T(7), a8 = V{} + T(8), a9 = V{} + T(9), a10 = V{} + T(10), a11 = V{} + T(11);
  for (long i = 0; i < steps; ++i) {
    a0 = a0 * m + c, a1 = a1 * m + c, a2 = a2 * m + c, a3 = a3 * m + c;
    a4 = a4 * m + c, a5 = a5 * m + c, a6 = a6 * m + c, a7 = a7 * m + c;
    a8 = a8 * m + c, a9 = a9 * m + c, a10 = a10 * m + c, a11 = a11 * m + c;
  }
  double sum = 0;
  const V all[kAccumulators] = {a0, a1, a2, a3, a4, a5, a6, a7, a8, a9, a10, a11};
  for (const V& a : all) sum += lanes_sum<V, T>(a);
  return sum;
}

double sum(const double* begin, long count) {
  const auto* p = reinterpret_cast<const Doubles*>(begin);
  const auto* const end = reinterpret_cast<const Doubles*>(begin + count);
  Doubles a0{}, a1{}, a2{}, a3{}, a4{}, a5{}, a6{}, a7{}, a8{}, a9{}, a10{}, a11{};
  for (; p != end; p += kAccumulators) {
    a0 += p[0], a1 += p[1], a2 += p[2], a3 += p[3], a4 += p[4], a5 += p[5];
    a6 += p[6], a7 += p[7], a8 += p[8], a9 += p[9], a10 += p[10], a11 += p[11];
  }
  return lanes_sum<Doubles, double>(((a0 + a1) + (a2 + a3)) + ((a4 + a5) + (a6 + a7)) +
                                    ((a8 + a9) + (a10 + a11)));
}

}  // namespace

extern const PeakLoops HALFWAY_LOOPS = {kLanes<Doubles, double>, kLanes<Floats, float>,
                                        multiply_add<Doubles, double>, multiply_add<Floats, float>, sum};

}  // namespace halfway::bench
