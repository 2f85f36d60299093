// A request of `halfway eval`: from a line's tree to a joint, poses of its nodes and what is wanted.
#pragma once

#include "reference/face/registry.hpp"
#include "reference/scene/text/document.hpp"

namespace halfway::reports {

struct PosePair {
  Pose<double> a, b;  ///< of the nodes, m, global axes
};

struct EvalRequest {
  const reference::Entry* entry = nullptr;
  reference::JointSpec spec;
  std::vector<PosePair> poses;  ///< one, where the request has no "poses"
  bool is_block = false;        ///< it has
  bool strain = false, loads = false, tangent = false, energy = false;
};

/// @param line  one object; gathers the notes on what was normalised.
/// @throws reference::Refusal naming the first field that is wrong
EvalRequest read_request(reference::Document& line);

}  // namespace halfway::reports
