#include "reference/identify/data.hpp"

#include <cmath>

namespace halfway::reference::identify {

int measured_count(const Data& data) {
  int count = 0;
  for (const LoadCase& one : data.cases) {
    for (int i = first_component(data.kind); i < end_component(data.kind); ++i)
      count += one.is_measured(i) ? int(one.loads.size()) : 0;
  }
  return count;
}

std::array<double, kChannels> sizes(const Data& data) {
  std::array<double, kChannels> sum{}, count{};
  const auto add = [&](std::size_t channel, double value) {
    if (value == 0) return;
    sum[channel] += value * value;
    count[channel] += 1;
  };
  for (const LoadCase& one : data.cases) {
    for (std::size_t row = 0; row < one.loads.size(); ++row) {
      for (int i = 0; i < 6; ++i) {
        add(i < 3 ? 0 : 1, one.motions[row][i]);
        add(i < 3 ? 2 : 3, one.loads[row][i]);
      }
    }
  }
  for (std::size_t c = 0; c < kChannels; ++c) sum[c] = count[c] > 0 ? std::sqrt(sum[c] / count[c]) : 0;
  return sum;
}

}  // namespace halfway::reference::identify
