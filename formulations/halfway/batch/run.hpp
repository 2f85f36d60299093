// From a batch to calls of its kernel: shares of the threads, whole packs, and the last joints.
#pragma once

#include "halfway/batch/batch.hpp"

namespace halfway::batch::detail {

template <class T>
struct Work {
  const Model& model;
  const Joints<T>& joints;
  const Results<T>& results;
  Output output;
  Evaluate<T> function;
  Spread<T> spread, streamed;  ///< nullptr: the function writes to the tables itself
  int lanes;                   ///< joints in one pack
  int tangent_rows;            ///< of the output
  int kept_rows;               ///< that the function writes: as many, or all for a spread to choose from
};

template <class T>
void run(const Work<T>& work, const Options& options);

}  // namespace halfway::batch::detail
