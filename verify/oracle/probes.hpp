// Generic probes: poses, ends and laws without any symmetry, fixed seed, exact in double.
#pragma once

#include "reference/face/instantiations.hpp"  // extern: the checks compile none of it again

#include <string>
#include <vector>

namespace halfway::verify {

using reference::Entry;
using reference::JointSpec;
using reference::Real50;

struct Probe {
  JointSpec spec;
  Pose<double> a, b;  ///< orthonormal to rounding
  double phi = 0;     ///< relative rotation, rad
};

/// `count` probes with relative rotations up to `largest_phi`, anisotropic stiffness with distinct
/// entries, offsets and joint frames on both ends; the law is block diagonal where the entry asks.
std::vector<Probe> probes(const Entry& entry, Kind kind, int count, double largest_phi);

inline constexpr Kind kKinds[] = {Kind::angular, Kind::linear, Kind::linear_angular};

}  // namespace halfway::verify
