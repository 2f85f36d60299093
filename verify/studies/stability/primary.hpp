// The primary path of a check.
#pragma once

#include "reference/solve/stability/critical.hpp"

#include <stdexcept>
#include <string>

namespace halfway::verify {

/// The path about an axis, which has to begin: loads that are no number at the unstrained pose would else
/// pass for those of a joint that never becomes unstable.
inline reference::PrimaryPath path_of(const reference::Entry& entry, const reference::JointSpec& spec,
                                      int axis) {
  reference::PrimaryPath path(entry, spec, axis);
  if (path.end_angle() > 0) return path;
  throw std::runtime_error(std::string(entry.name) + " has no path about axis " + std::to_string(axis + 1) +
                           ": it ends where it begins");
}

}  // namespace halfway::verify
