// The joints of a chain as the sweeps evaluate them.
#pragma once

#include "reference/chain/chain.hpp"
#include "reference/chain/loops/sweep.hpp"

namespace halfway::reference::chain::detail {

/// Of a joint: EA, GA2, GA3, GJ, EI2, EI3 over h.
Eigen::Matrix<double, 6, 1> stiffness(const Chain& chain);

/// Code and law. Throws std::invalid_argument as batch::Batch does.
class Joints {
 public:
  Joints(const Chain& chain, const Settings& settings);
  Joints(const Joints&) = delete;
  Joints& operator=(const Joints&) = delete;
  const Evaluation& how() const { return how_; }

 private:
  void set_tangent(const batch::Batch& batch, NodeOrder order);

  Evaluation how_;
  alignas(64) double law_[21 * kChunk] = {};
};

}  // namespace halfway::reference::chain::detail
