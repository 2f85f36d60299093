// CPU times of a few long-running loops, interleaved so that a slow moment of the machine hits all.
#pragma once

#include <algorithm>
#include <ctime>
#include <functional>
#include <vector>

namespace halfway::bench {

/// CPU time of this thread, ns.
inline double cpu_ns() {
  std::timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e9 * double(t.tv_sec) + double(t.tv_nsec);
}

/// The median CPU time of each run, ns, over an odd number of repetitions.
inline std::vector<double> interleaved_medians(const std::vector<std::function<void()>>& runs,
                                               int repetitions) {
  std::vector<std::vector<double>> times(runs.size());
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double begin = cpu_ns();
      runs[i]();
      times[i].push_back(cpu_ns() - begin);
    }
  }
  std::vector<double> medians;
  for (auto& t : times) {
    std::ranges::nth_element(t, t.begin() + repetitions / 2);
    medians.push_back(t[repetitions / 2]);
  }
  return medians;
}

}  // namespace halfway::bench
