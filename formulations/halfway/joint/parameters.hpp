// What a formulation may ask for beside its law: numbers of the joint, none of a pose.
#pragma once

namespace halfway {

/// Each is read by the formulations that have it and by no other.
struct Parameters {
  double xi = 0.5;    ///< frame of `intrinsic`, any number
  double length = 1;  ///< of the rod of `rod34`, m, > 0
  int axis = 1;       ///< 1, 2, 3: joint axis along which that rod runs from a to b; -1, -2, -3: against it
};

}  // namespace halfway
