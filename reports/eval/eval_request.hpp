// A request of `halfway eval`: from JSON to a joint, two poses and what is wanted.
#pragma once

#include "reference/face/registry.hpp"
#include "reports/eval/eval_error.hpp"

#include <nlohmann/json.hpp>

namespace halfway::reports {

struct EvalRequest {
  const reference::Entry* entry = nullptr;
  reference::JointSpec spec;
  Pose<double> a, b;  ///< of the nodes, m, global axes
  bool strain = false, loads = false, tangent = false, energy = false;
};

/// @param line  one JSON object
/// @throws EvalError naming the first field that is wrong
EvalRequest read_request(const nlohmann::json& line);

}  // namespace halfway::reports
