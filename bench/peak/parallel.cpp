#include "bench/peak/parallel.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <thread>

namespace halfway::bench {
namespace {

/// A chain of dependent multiply-adds: the processor's memory has no part in it.
void compute() {
  double x = 1;
  benchmark::DoNotOptimize(x);  // not known before: or the loop might move away from the clock
  for (int i = 0; i < 1'000'000; ++i) x = x * 0.999999 + 1e-6;
  benchmark::DoNotOptimize(x);
}

template <class Work>
double seconds(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

double measured_parallel() {
  std::array<double, 15> gains;
  for (double& gain : gains) {
    const double one = seconds(compute);
    const double two = seconds([] {
      const std::jthread other(compute);
      compute();
    });
    gain = 2 * one / two;
  }
  std::ranges::sort(gains);
  return gains[gains.size() / 2];
}

}  // namespace halfway::bench
