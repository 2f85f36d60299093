// halfway_bench: Google Benchmark's own command line over the suite's cases; --help lists its flags.
#include <cstdio>
#include <exception>

#include "bench/harness/case.hpp"

int main(int argc, char** argv) try {
  halfway::bench::register_all();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
} catch (const std::exception& error) {
  std::fprintf(stderr, "halfway_bench: %s\n", error.what());
  return 1;
}
