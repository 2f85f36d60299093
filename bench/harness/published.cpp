#include "bench/harness/published.hpp"

namespace halfway::bench {
namespace {

// One measurement of all of them: g++ 12.2, medians. The figures name no version where it was not recorded.
constexpr const char* kMachine = "one core of a shared 2-core AVX-512 Xeon";
constexpr const char* kDate = "date not recorded";
constexpr const char* kSource =
    "the project's preliminary study of other programs' costs, before this suite; not repeated in this run";

Published figure(const char* program, const char* version, const char* what, double ns) {
  return {program, version, what, ns, kMachine, kDate, kSource};
}

}  // namespace

std::vector<Published> published() {
  return {
      figure("MBDyn", "1.7.3", "exp", 36),
      figure("MBDyn", "1.7.3", "log", 93),
      figure("MBDyn", "1.7.3", "residual, invariant angular", 213),
      figure("MBDyn", "1.7.3", "residual, invariant linear", 295),
      figure("MBDyn", "1.7.3", "residual, invariant linear/angular", 329),
      figure("MBDyn", "1.7.3", "residual + tangent, invariant angular", 421),
      figure("MBDyn", "1.7.3", "residual + tangent, invariant linear; the tangent is wrong by 7-111 %", 695),
      figure("MBDyn", "1.7.3",
             "residual + tangent, invariant linear/angular; the tangent is wrong by 7-111 %", 869),
      figure("Simbody", "", "exp", 29),
      figure("Simbody", "", "log", 51),
      figure("Simbody", "", "residual, LinearBushing", 124),
      figure("Simbody", "", "residual, LinearBushing in a System, at the least (at the most 370)", 312),
      figure("Exudyn", "", "exp", 39),
      figure("Exudyn", "", "log", 31),
      figure("Exudyn", "", "residual, intrinsic", 235),
      figure("Exudyn", "", "residual, attached", 83),
      figure("Chrono", "", "exp", 25),
      figure("Chrono", "", "log", 26),
      figure("Chrono", "", "residual, body-body bushing", 1030),
      figure("Chrono", "", "residual + tangent, body-body bushing; numerical, error 1e-8", 25900),
      figure("Drake", "", "log", 74),
      figure("Drake", "", "residual, LinearBushingRollPitchYaw", 131),
      figure("Sophus", "", "exp", 29),
      figure("Sophus", "", "log", 45),
      figure("manif", "", "exp", 31),
      figure("manif", "", "log", 64),
      figure("Pinocchio", "", "exp", 28),
      figure("Pinocchio", "", "log", 186),
  };
}

}  // namespace halfway::bench
