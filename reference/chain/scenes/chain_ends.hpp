// What holds the ends of a chain where they are: reactions of its first and its last joint.
#pragma once

#include "reference/chain/chain.hpp"
#include "reference/face/registry.hpp"

#include <array>
#include <optional>
#include <vector>

namespace halfway::reference {

/// The joint at the middle of a link, its node a the one nearer to the root or the other, as the chain's
/// order says.
JointSpec chain_joint(const Entry& entry, const chain::Chain& chain);

/// Force (N) and moment about the node (N m), global axes, that the joints ask for to hold the first node and
/// the last one there: q = dU/dx. Zero where it is rounding; none where it is known to less than 1e-5 of its
/// size, since positions of very many links are.
using EndsHeld = std::array<Eigen::Matrix<double, 6, 1>, 2>;
std::optional<EndsHeld> holding_ends(const Entry& entry, const chain::Chain& chain,
                                     const std::vector<chain::Node>& nodes);

}  // namespace halfway::reference
