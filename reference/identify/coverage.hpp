// How often the stated intervals hold the truth: noisy data of known joints, identified again and again.
#pragma once

#include "reference/identify/identification.hpp"

#include <cstdint>

namespace halfway::reference::identify {

/// A known joint under a programme of loads, without noise.
struct Bench {
  std::string name;
  Data data;                              ///< exact
  std::array<double, kChannels> noise{};  ///< standard deviations that are added to what was measured
  JointValues truth;
  bool is_per_pair = false;  ///< xi differ by the pair
};

/// angular: `intrinsic`, xi = 0.37. per_pair: three xi. full: `intrinsic` with six strains, turned axes, a
/// joint point off the body, coupling left. held: the same, half of the cases with node b held.
const std::vector<std::string>& bench_names();
Bench bench(const std::string& name);

/// The data with noise of that seed: Gaussian, independent, the same on every machine.
Data noisy(const Bench& bench, std::uint64_t seed);

/// One quantity's intervals.
struct Coverage {
  std::string quantity;
  int trials = 0;   ///< in which it was identified
  int covered = 0;  ///< in which its interval holds the truth
  double share() const { return double(covered) / trials; }
};

/// @param spoil  multiplies all half widths: 1; another number shows that the count can fail
std::vector<Coverage> coverage(const Bench& bench, int trials, double spoil = 1);

}  // namespace halfway::reference::identify
