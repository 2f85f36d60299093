// Newton for a chain: one iteration is a sweep to the tip and one back.
#pragma once

#include "reference/chain/links.hpp"

#include <Eigen/LU>

namespace halfway::reference::chain::detail {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;

/// What the last link is subject to: loads about its rear end, and how they change with its motion.
struct TipLoads {
  Vec6 load = Vec6::Zero();
  Mat6 by_motion = Mat6::Zero();
};

/// What ends a chain beyond its joints.
class Tip {
 public:
  virtual ~Tip() = default;
  /// The last link's increment. @param reduced  S and residual of the last link
  virtual Vec6 increment(const State& state, double factor, const AtTip& reduced, bool new_tangent) = 0;
  /// Loads on the last link.
  virtual Vec6 load(const State& state, double factor, const AtTip& internal) const = 0;
  /// Solution::tip_stiffness, in balance at all loads.
  virtual std::optional<Eigen::Matrix<double, 6, 6>> stiffness(const State&, const AtTip&) const {
    return std::nullopt;
  }
};

/// Loads on a free end.
class FreeTip : public Tip {
 public:
  FreeTip(const EndLoads& loads, bool symmetrised) : loads_(loads), symmetrised_(symmetrised) {}
  Vec6 increment(const State& state, double factor, const AtTip& reduced, bool new_tangent) override;
  Vec6 load(const State& state, double factor, const AtTip&) const override { return at(state, factor).load; }
  std::optional<Eigen::Matrix<double, 6, 6>> stiffness(const State& state,
                                                       const AtTip& reduced) const override;

 private:
  TipLoads at(const State& state, double factor) const;
  EndLoads loads_;
  bool symmetrised_;
  Eigen::PartialPivLU<Mat6> tangent_{};
};

/// An end that is led from its place at rest to a pose.
class HeldTip : public Tip {
 public:
  HeldTip(const Pose<double>& rest, const Pose<double>& last);
  Vec6 increment(const State& state, double factor, const AtTip& reduced, bool new_tangent) override;
  /// The support's.
  Vec6 load(const State&, double, const AtTip& internal) const override;

 private:
  Pose<double> rest_;
  Vec3<double> way_, turn_;
};

/// All load steps.
Solution newton(const Chain& chain, const Settings& settings, State& state, Tip& tip, AtTip& internal);

}  // namespace halfway::reference::chain::detail
