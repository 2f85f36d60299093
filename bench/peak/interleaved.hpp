// CPU times of a few long-running loops, interleaved so that a slow moment of the machine hits all.
#pragma once

#include <algorithm>
#include <cmath>
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

/// The least CPU time of each run, ns: a limit of the machine, which neighbours can only hide.
inline std::vector<double> interleaved_bests(const std::vector<std::function<void()>>& runs,
                                             int repetitions) {
  std::vector<double> best(runs.size(), HUGE_VAL);
  for (int repetition = 0; repetition < repetitions; ++repetition) {
    for (std::size_t i = 0; i < runs.size(); ++i) {
      const double begin = cpu_ns();
      runs[i]();
      best[i] = std::min(best[i], cpu_ns() - begin);
    }
  }
  return best;
}

}  // namespace halfway::bench
