#include "reference/chain/scenes/chain_ends.hpp"

#include "reference/record/worst.hpp"

#include <algorithm>
#include <utility>

namespace halfway::reference {
namespace {

/// Where the stress-free curve is after arc length s, seen from where it starts.
JointEnd<double> along_curve(const Vec3<double>& curvature, double s) {
  const Vec3<double> turn = s * curvature;
  return {so3::gamma<double>(turn) * Vec3<double>(s, 0, 0), so3::exp<double>(turn)};
}

/// What rounding of the nodes' poses leaves of a force, N, and of a moment, N m: a node is some ten roundings
/// of a running sum from its neighbours, a few eps each.
std::pair<double, double> rounding(const chain::Chain& c, const std::vector<chain::Node>& nodes) {
  constexpr double kUnit = 32 * Eigen::NumTraits<double>::epsilon();
  const double h = c.length / double(c.links);
  double reach = h;
  for (const std::size_t i : {std::size_t(0), std::size_t(1), nodes.size() - 2, nodes.size() - 1})
    keep_largest(reach, chain::pose(nodes[i]).x.norm());
  const double force = std::max({c.section.EA, c.section.GA2, c.section.GA3}) / h * (kUnit * reach);
  const double bends = std::max({c.section.GJ, c.section.EI2, c.section.EI3});
  return {force, bends / h * kUnit + h * force};
}

/// @return  is it known?
bool cleared(double rounding, Eigen::Ref<Vec3<double>> of_end) {
  const double size = of_end.cwiseAbs().maxCoeff();
  if (size <= rounding) of_end.setZero();
  return !(size > rounding && rounding > 1e-5 * size);
}

}  // namespace

JointSpec chain_joint(const Entry& entry, const chain::Chain& c) {
  const double h = c.length / double(c.links);
  const chain::Section& s = c.section;
  JointSpec out;
  out.kind = Kind::linear_angular;
  out.xi = c.xi.value_or(out.xi);
  Eigen::VectorXd k(6);
  k << s.EA, s.GA2, s.GA3, s.GJ, s.EI2, s.EI3;
  if (entry.needs_length) {  // the whole of its link: what bends gives way across as well, h^3/(12 EI)
    k[1] = 1 / (1 / k[1] + h * h / (12 * s.EI3)), k[2] = 1 / (1 / k[2] + h * h / (12 * s.EI2));
    out.length = h, out.axis = c.node_order == chain::NodeOrder::tip_first ? -1 : 1;
  }
  out.law = LinearSpec{Eigen::MatrixXd((k / h).asDiagonal())};
  out.a = along_curve(c.curvature, h / 2);
  out.b = along_curve(c.curvature, -h / 2);
  if (c.node_order == chain::NodeOrder::tip_first) std::swap(out.a, out.b);
  return out;
}

std::optional<EndsHeld> holding_ends(const Entry& entry, const chain::Chain& c,
                                     const std::vector<chain::Node>& nodes) {
  const JointSpec spec = chain_joint(entry, c);
  const bool root_first = c.node_order == chain::NodeOrder::root_first;
  /// Of the joint between two nodes, on the one nearer to the root and on the other.
  const auto of_joint = [&](const chain::Node& inner, const chain::Node& outer) -> EndsHeld {
    const Pose<double> near = chain::pose(inner), far = chain::pose(outer);
    const auto q = node_loads<double>(entry, spec, root_first ? near : far, root_first ? far : near, false).q;
    if (root_first) return {q.head<6>(), q.tail<6>()};
    return {q.tail<6>(), q.head<6>()};
  };
  EndsHeld out{of_joint(nodes[0], nodes[1])[0], of_joint(nodes[nodes.size() - 2], nodes.back())[1]};
  const auto [force, moment] = rounding(c, nodes);
  for (auto& end : out) {
    const bool is_known = cleared(force, end.head<3>()), turns = cleared(moment, end.tail<3>());
    if (!is_known || !turns) return std::nullopt;
  }
  return out;
}

}  // namespace halfway::reference
