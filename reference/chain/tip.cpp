#include "reference/chain/newton.hpp"

namespace halfway::reference::chain::detail {
namespace {

Vec6 pair(const Vec3<double>& a, const Vec3<double>& b) {
  Vec6 out;
  out << a, b;
  return out;
}

Vec6 residual_of(const AtTip& reduced) { return Eigen::Map<const Vec6>(reduced.residual); }

}  // namespace

TipLoads FreeTip::at(const State& state, double factor) const {
  const Mat3<double> R = state.last_node();
  const Vec3<double> arm = state.last_arm(), turning = factor * (R * loads_.follower_force),
                     couple = factor * (R * loads_.follower_moment), f = factor * loads_.force + turning;
  const Mat3<double> V = factor * loads_.virial * R.transpose();
  const Vec3<double> of_virial(V(2, 1) - V(1, 2), V(0, 2) - V(2, 0), V(1, 0) - V(0, 1));
  TipLoads out;
  out.load = pair(f, factor * loads_.moment + couple + of_virial + arm.cross(f));
  // d(arm) x f = [f][arm] w; what turns with the node changes by -[load] w; of the virial (w x r) x f = r (f
  // . w) - (f . r) w.
  out.by_motion.topRightCorner<3, 3>() = -skew(turning);
  out.by_motion.bottomRightCorner<3, 3>() = -skew(couple) + skew(f) * skew(arm) - skew(arm) * skew(turning) +
                                            V.transpose() - V.trace() * Mat3<double>::Identity();
  return out;
}

Vec6 FreeTip::increment(const State& state, double factor, const AtTip& reduced, bool new_tangent) {
  const TipLoads loads = at(state, factor);
  if (new_tangent) {
    const Mat6 by =
        symmetrised_ ? Mat6((loads.by_motion + loads.by_motion.transpose()) / 2) : loads.by_motion;
    tangent_.compute(Eigen::Map<const Mat6>(reduced.S) - by);
  }
  return tangent_.solve(residual_of(reduced) + loads.load);
}

std::optional<Eigen::Matrix<double, 6, 6>> FreeTip::stiffness(const State& state,
                                                              const AtTip& reduced) const {
  Mat6 of_node = Mat6::Identity();  // (dx, w) of the node moves the rear end by dx + [arm] w
  of_node.topRightCorner<3, 3>() = skew<double>(state.last_arm());
  return Mat6(of_node.transpose() * (Eigen::Map<const Mat6>(reduced.S) - at(state, 1).by_motion) * of_node);
}

HeldTip::HeldTip(const Pose<double>& rest, const Pose<double>& last)
    : rest_(rest), way_(last.x - rest.x), turn_(so3::log(Mat3<double>(last.R * rest.R.transpose()))) {}

Vec6 HeldTip::increment(const State& state, double factor, const AtTip& reduced, bool) {
  const Mat3<double> R = so3::exp<double>(factor * turn_) * rest_.R;
  const Vec3<double> w = so3::log(Mat3<double>(R * state.last_node().transpose()));
  const Vec3<double> rear = state.origin() + Eigen::Map<const Vec3<double>>(reduced.x);
  return pair(rest_.x + factor * way_ - so3::exp<double>(w) * state.last_arm() - rear, w);
}

Vec6 HeldTip::load(const State&, double, const AtTip& internal) const { return -residual_of(internal); }

}  // namespace halfway::reference::chain::detail
