#include "bench/peak/peak.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "bench/peak/interleaved.hpp"
#include "bench/peak/isa.hpp"

namespace halfway::bench {
namespace {

constexpr long kSteps = 500'000;  // some 1 ms; whole numbers to there are exact in float
constexpr int kRepetitions = 21;

/// With factor 1 and term 1 each accumulator counts its steps; no compiler knows that they are.
template <class T>
void run(const Isa& isa, double (*loop)(long, T, T), int lanes) {
  volatile T one = 1;
  const double sum = loop(kSteps, one, one);
  const double expected = lanes * (kAccumulators * double(kSteps) + kAccumulators * (kAccumulators - 1) / 2);
  if (sum != expected) {
    throw std::runtime_error(
        fmt::format("peak of {}: the loop returned {:.17g}, not {:.17g}", isa.name, sum, expected));
  }
}

}  // namespace

Peaks measured_peaks() {
  Peaks peaks;
  std::vector<std::function<void()>> runs;
  std::vector<double> flops;
  const auto add = [&](const Isa& isa, const char* precision, auto loop, int lanes) {
    peaks.push_back({isa.name, precision, 0});
    runs.push_back([=] { run(isa, loop, lanes); });
    flops.push_back(2.0 * lanes * kAccumulators * kSteps);
  };
  for (const Isa& isa : available_isas()) {
    add(isa, "double", isa.loops->doubles, isa.loops->double_lanes);
    add(isa, "float", isa.loops->floats, isa.loops->float_lanes);
  }
  const auto ns = interleaved_bests(runs, kRepetitions);
  for (std::size_t i = 0; i < peaks.size(); ++i) peaks[i].flops_per_ns = flops[i] / ns[i];
  return peaks;
}

Peaks larger(Peaks a, const Peaks& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    a[i].flops_per_ns = std::max(a[i].flops_per_ns, b[i].flops_per_ns);
  return a;
}

}  // namespace halfway::bench
