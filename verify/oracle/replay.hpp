// What measures a failure once more: the request of `halfway eval` that has its pose and its law.
#pragma once

#include "reference/face/registry.hpp"

#include <string>

namespace halfway::verify {

/// One line of JSON. A compliance is written as the stiffness that it is.
std::string eval_request(const std::string& formulation, const reference::JointSpec& spec,
                         const Pose<double>& a, const Pose<double>& b);

}  // namespace halfway::verify
