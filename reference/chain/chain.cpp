#include "reference/chain/chain.hpp"

#include "reference/chain/newton.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace halfway::reference::chain {
namespace {

[[noreturn]] void refuse(const std::string& what) { throw std::invalid_argument("chain: " + what); }

void positive(const char* name, double x) {
  if (!(x > 0) || !std::isfinite(x)) refuse(fmt::format("{} is {}, not a positive number", name, x));
}
void finite(const char* name, const Eigen::MatrixXd& v) {
  if (!v.allFinite()) refuse(fmt::format("{} has an entry that is not finite", name));
}

/// To what a file with nine digits can say.
void rotation(const char* name, const Mat3<double>& R) {
  const double off = (R.transpose() * R - Mat3<double>::Identity()).cwiseAbs().maxCoeff();
  if (!(off < 1e-8) || !(R.determinant() > 0))
    refuse(fmt::format("{}: R is no rotation, off by {:.1e}", name, off));
}

void validate(const Chain& c) {
  if (c.links < 1) refuse(fmt::format("{} links", c.links));
  positive("length", c.length);
  const Section& s = c.section;
  positive("GJ", s.GJ), positive("EI2", s.EI2), positive("EI3", s.EI3);
  positive("EA", s.EA), positive("GA2", s.GA2), positive("GA3", s.GA3);
  finite("curvature", c.curvature), finite("root", c.root.x);
  rotation("root", c.root.R);
}
void validate(const Settings& s) {
  if (s.load_steps < 1) refuse(fmt::format("{} load steps", s.load_steps));
  if (s.most_iterations < 1) refuse(fmt::format("{} iterations", s.most_iterations));
  if (!(s.spin_cap > 0)) refuse(fmt::format("spin cap {}, not a positive number", s.spin_cap));
}

bool keeps(const Settings& s) {
  return s.tangent == Tangent::frozen_first || s.tangent == Tangent::frozen_step;
}

}  // namespace

Pose<double> pose(const Node& node) {
  return {{node.x[0], node.x[1], node.x[2]}, detail::rotation_matrix(detail::Quat(node.q))};
}

Solution solve(const Chain& chain, const EndLoads& loads, const Settings& settings) {
  validate(chain), validate(settings);
  finite("force", loads.force), finite("follower_force", loads.follower_force);
  finite("moment", loads.moment), finite("follower_moment", loads.follower_moment);
  finite("virial", loads.virial);
  detail::State state(chain, keeps(settings));
  detail::FreeTip tip(loads, settings.tangent == Tangent::symmetrised);
  detail::AtTip at_tip;
  return detail::newton(chain, settings, state, tip, at_tip);
}

Held solve_held(const Chain& chain, const Pose<double>& last, const Settings& settings) {
  validate(chain), validate(settings);
  finite("last", last.x), rotation("last", last.R);
  detail::State state(chain, keeps(settings));
  detail::HeldTip tip(pose(state.nodes().back()), last);
  detail::AtTip at_tip;
  Held out{detail::newton(chain, settings, state, tip, at_tip), Vec3<double>::Zero(), Vec3<double>::Zero()};
  const detail::Vec6 load = tip.load(state, 1, at_tip);
  out.force = load.head<3>();
  out.moment = load.tail<3>() - state.last_arm().cross(out.force);
  return out;
}

std::vector<Node> at_rest(const Chain& chain) {
  validate(chain);
  return detail::State(chain, false).nodes();
}

}  // namespace halfway::reference::chain
