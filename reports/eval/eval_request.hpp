// A request of `halfway eval`: from a line's tree to a joint, two poses and what is wanted.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/scene/document.hpp"

namespace halfway::reports {

struct EvalRequest {
  const reference::Entry* entry = nullptr;
  reference::JointSpec spec;
  Pose<double> a, b;  ///< of the nodes, m, global axes
  bool strain = false, loads = false, tangent = false, energy = false;
};

/// @param line  one object; gathers the notes on what was normalised.
/// @throws reference::Refusal naming the first field that is wrong
EvalRequest read_request(reference::Document& line);

}  // namespace halfway::reports
