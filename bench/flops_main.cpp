// halfway_flops: counts the flops of every joint.
//   halfway_flops record FILE   keeps them in FILE
//   halfway_flops check         compares them with those kept in bench/flops.json
#include "bench/questions/kernels/count_flops.hpp"
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

/// Counts are whole numbers, of transcriptions means of 32: none may differ.
int check(const Flops& counted) {
  int different = 0;
  for (const auto& [name, flops] : counted) {
    if (!kept_flops().contains(name)) {  // a new formulation's: until they are recorded its rows have none
      std::printf("not kept yet: %s: %.17g flops\n", name.c_str(), flops);
      continue;
    }
    if (kept_flops(name) == flops) continue;
    ++different;
    std::printf("FAIL %s: %.17g flops, kept %.17g\n", name.c_str(), flops, kept_flops(name));
  }
  for (const auto& [name, flops] : kept_flops()) {
    if (counted.contains(name)) continue;
    ++different;
    std::printf("FAIL %s: kept, and no longer counted\n", name.c_str());
  }
  std::printf("%zu counts, %d differ%s\n", counted.size(), different,
              different > 0 ? "; meant so: halfway_flops record bench/flops.json" : "");
  return counted.empty() || different > 0 ? 1 : 0;
}

}  // namespace
}  // namespace halfway::bench

int main(int argc, char** argv) try {
  using namespace halfway::bench;
  const std::string command = argc > 1 ? argv[1] : "";
  if (command == "record" && argc == 3) return write_flops(argv[2], with_variants(count_all())), 0;
  if (command == "check" && argc == 2) return check(with_variants(count_all()));
  return std::fputs("usage: halfway_flops record FILE | check\n", stderr), 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "halfway_flops: %s\n", error.what());
  return 1;
}
