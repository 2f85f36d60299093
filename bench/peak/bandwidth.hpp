// The memory's limit, measured in this process by one core.
#pragma once

#include <string>
#include <vector>

namespace halfway::bench {

struct Bandwidth {
  std::string what;         ///< read, copy, nontemporal from DRAM; read_l1, read_l2 where sizes are known
  double bytes_per_ns = 0;  ///< bytes the program reads and writes; CPU time
};
using Bandwidths = std::vector<Bandwidth>;

/// read: a sum; copy: b = factor * a with ordinary stores (the hardware reads b besides: not counted);
/// nontemporal: stores past the caches (x86 only). Some 0.5 s. Throws std::runtime_error when a loop
/// does not leave the numbers that it must.
Bandwidths measured_bandwidths();

}  // namespace halfway::bench
