// Which thread puts what: whole packs of joints, of which a thread puts the rows that are its own.
#pragma once

#include "halfway/assemble/scatter.hpp"

#include <vector>

namespace halfway::assemble::detail {

/// The packs that touch a thread's rows; what of their lanes belongs to others goes nowhere. Packs are the
/// same for any number of threads, and the order in which a number of the matrix is summed with them.
struct Share {
  long begin = 0, end = 0;  ///< its part of the residual
  std::vector<Target> targets;
};

/// Joints first .. first + count of a pattern, by packs.
struct Packs {
  long first, count;
  int lanes;          ///< of a pack
  int lanes_at_once;  ///< that are put together
  const int* order;   ///< in which their blocks are put
  int inset;          ///< from the first unknown of a node to the first that the joints load
};

std::vector<Share> share_out(const Pattern& pattern, const Packs& packs, int threads);

}  // namespace halfway::assemble::detail
