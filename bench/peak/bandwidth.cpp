#include "bench/peak/bandwidth.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <stdexcept>

#include "bench/peak/interleaved.hpp"
#include "bench/peak/isa.hpp"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace halfway::bench {
namespace {

constexpr int kRepetitions = 7;
constexpr long kLine = 8 * kAccumulators;  // doubles: what PeakLoops::sum asks for

/// Bytes of the largest data or unified cache of a level, or 0 where the system does not say. The
/// kernel's own table: in a virtual machine sysconf may tell the host's.
long cache_size(int level) {
  long size = 0;
  for (int index = 0; index < 8; ++index) {
    const auto file = fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/", index);
    int of_level = 0;
    long kilobytes = 0;
    std::string type;
    if (!(std::ifstream(file + "level") >> of_level) || of_level != level) continue;
    if ((std::ifstream(file + "type") >> type) && type == "Instruction") continue;
    if (std::ifstream(file + "size") >> kilobytes) size = std::max(size, 1024 * kilobytes);
  }
  return size;
}

long last_level_size() {
  const long size = std::max({cache_size(3), cache_size(2)});
  return size > 0 ? size : std::max(0L, sysconf(_SC_LEVEL3_CACHE_SIZE));
}

struct Free {
  void operator()(void* p) const { std::free(p); }
};
using Array = std::unique_ptr<double[], Free>;

/// `count` doubles, all of them 1, in memory that is there.
Array ones(long count) {
  Array out(static_cast<double*>(std::aligned_alloc(64, count * sizeof(double))));
  if (!out) throw std::runtime_error(fmt::format("no memory for {} doubles", count));
  std::fill_n(out.get(), count, 1.0);
  return out;
}

/// A factor, so that no compiler calls memcpy, which has a way of its own for large arrays.
void scaled_copy(const double* from, double* to, long count, double factor) {
  for (long i = 0; i < count; ++i) to[i] = factor * from[i];
}

#ifdef __SSE2__
void stream(double* to, long count, double value) {
  const __m128d pair = _mm_set1_pd(value);
  for (long i = 0; i < count; i += 2) _mm_stream_pd(to + i, pair);
  _mm_sfence();
}
#endif

/// A loop that did not do its work has no speed.
void expect(const char* what, double found, double expected) {
  if (found != expected)
    throw std::runtime_error(
        fmt::format("bandwidth, {}: {:.17g} where {:.17g} must be", what, found, expected));
}

struct Loops {
  std::vector<std::string> what;
  std::vector<double> bytes;
  std::vector<std::function<void()>> runs;
  void add(const std::string& name, double bytes_moved, std::function<void()> run) {
    what.push_back(name), bytes.push_back(bytes_moved), runs.push_back(std::move(run));
  }
};

}  // namespace

Bandwidths measured_bandwidths() {
  const auto sum = available_isas().back().loops->sum;
  // Four times the last cache: a quarter at most could still be in it. Bounded for odd machines.
  const long bytes = std::clamp(4 * last_level_size(), 128L << 20, 512L << 20);
  const long count = bytes / long(sizeof(double)) / kLine * kLine;
  const Array from = ones(count), to = ones(count);
  const double size = double(count) * sizeof(double);

  Loops loops;
  loops.add("read", size, [&] { expect("read", sum(from.get(), count), double(count)); });
  double factor = 1;
  loops.add("copy", 2 * size, [&] {
    scaled_copy(from.get(), to.get(), count, ++factor);
    for (const long i : {0L, count / 2, count - 1}) expect("copy", to[i], factor);
  });
#ifdef __SSE2__
  loops.add("nontemporal", size, [&] {
    stream(to.get(), count, ++factor);
    for (const long i : {0L, count / 2, count - 1}) expect("nontemporal", to[i], factor);
  });
#endif
  for (const int level : {1, 2}) {
    const long part = cache_size(level) / 2 / long(sizeof(double)) / kLine * kLine;  // beside all else
    if (part == 0) continue;
    const long passes = count / part;
    loops.add(fmt::format("read_l{}", level), double(passes) * part * sizeof(double), [&, part, passes] {
      double total = 0;
      for (long pass = 0; pass < passes; ++pass) total += sum(from.get(), part);
      expect("read from a cache", total, double(passes) * part);
    });
  }
  const auto ns = interleaved_bests(loops.runs, kRepetitions);
  Bandwidths out;
  for (std::size_t i = 0; i < ns.size(); ++i) out.push_back({loops.what[i], loops.bytes[i] / ns[i]});
  return out;
}

}  // namespace halfway::bench
