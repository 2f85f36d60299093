// halfway_flops: counts the flops of every joint and keeps them.
//   halfway_flops record FILE   to FILE, which is bench/flops.json
#include "bench/questions/count_flops.hpp"
#include "halfway/systems/intrinsic.hpp"

#include <cstdio>
#include <exception>
#include <string>

namespace halfway::bench {

Flops count_all();

namespace {

/// The invariant angular kernel with a cheaper angle, as the benchmarks of that name.
template <class Angle>
void count_variant(Flops& flops, const std::string& name) {
  const Inputs in = inputs_of<Invariant>(Kind::angular);
  using Ends = kernel::Ends<reference::Counting>;
  count_kernel<Invariant, Kind::angular, false, kernel::Accuracy<Angle>, Ends>(flops, in, '/' + name);
  count_kernel<Invariant, Kind::angular, true, kernel::Accuracy<Angle>, Ends>(flops, in, '/' + name);
}

Flops with_variants(Flops flops) {
  count_variant<kernel::SmallAngle<1>>(flops, "order_1");
  count_variant<kernel::SmallAngle<2>>(flops, "order_2");
  count_variant<kernel::SmallAngle<3>>(flops, "order_3");
  count_variant<kernel::PolynomialAngle<4>>(flops, "log_4");
  count_variant<kernel::PolynomialAngle<8>>(flops, "log_8");
  count_variant<kernel::PolynomialAngle<12>>(flops, "log_12");
  count_variant<kernel::PolynomialAngle<18>>(flops, "log_18");
  return flops;
}

}  // namespace
}  // namespace halfway::bench

int main(int argc, char** argv) try {
  using namespace halfway::bench;
  if (argc != 3 || std::string(argv[1]) != "record")
    return std::fputs("usage: halfway_flops record FILE\n", stderr), 1;
  write_flops(argv[2], with_variants(count_all()));
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "halfway_flops: %s\n", error.what());
  return 1;
}
