// The solver's answer judged joint by joint: each node of a chain is in equilibrium by the loads that its
// joints have alone, on the run-time face, which shares neither batches nor sweeps with the solver.
#include "reference/chain/scenes/chain_ends.hpp"
#include "verify/check.hpp"
#include "verify/studies/chains/chain_orders.hpp"

#include <fmt/format.h>

namespace halfway::verify {
namespace {

namespace chain = reference::chain;
using reference::Entry;
using reference::JointSpec;
using reference::Measurement;

using Vec6 = Eigen::Matrix<double, 6, 1>;

/// Internal loads (f, m) on each node, less what acts on the last one.
std::vector<Vec6> imbalances(const Entry& entry, const chain::Chain& c, const chain::EndLoads& loads,
                             const std::vector<chain::Node>& nodes) {
  const JointSpec spec = reference::chain_joint(entry, c);
  const bool root_first = c.node_order == chain::NodeOrder::root_first;
  std::vector<Vec6> out(nodes.size(), Vec6::Zero());
  for (std::size_t j = 1; j < nodes.size(); ++j) {
    const std::size_t a = root_first ? j - 1 : j, b = root_first ? j : j - 1;
    const auto q = entry.in_double.point(spec, chain::pose(nodes[a]), chain::pose(nodes[b]), false).q;
    out[a] += q.head<6>();
    out[b] += q.tail<6>();
  }
  const Mat3<double> R = chain::pose(nodes.back()).R;
  out.back().head<3>() -= loads.force + R * loads.follower_force;
  out.back().tail<3>() -= loads.moment + R * loads.follower_moment;
  for (int k = 0; k < 3; ++k)  // dead forces, one at a unit of each axis of the node
    out.back().tail<3>() -= R.col(k).cross(loads.virial.col(k));
  return out;
}

/// Forces over EA/h L, moments over EA/h L^2: what a rounding of the positions makes of them, in eps.
Measurement worst_imbalance(const chain::Chain& c, const std::vector<Vec6>& all) {
  const double unit = c.section.EA * double(c.links) * 0x1p-52;
  Measurement worst;
  for (std::size_t i = 1; i < all.size(); ++i) {  // node 0 is clamped
    worst.include(reference::largest_entry<double>(all[i].head<3>()) / unit,
                  fmt::format("force, node {}", i));
    worst.include(reference::largest_entry<double>(all[i].tail<3>()) / (unit * c.length),
                  fmt::format("moment, node {}", i));
  }
  return worst;
}

Finding judged_balance(const Entry& entry, const std::string& what, const chain::Chain& c,
                       const chain::EndLoads& loads, const chain::Solution& found) {
  Measurement worst;
  if (found.converged) worst = worst_imbalance(c, imbalances(entry, c, loads, found.nodes));
  return finding(fmt::format("chains/{}/balance/{}", entry.name, what))
      .about("chains")
      .of(std::string(entry.name), "linear_angular")
      .measured(worst)
      .in("eps of EA/h L")
      .at_most(64, "a node is 12 roundings of a running sum from its neighbours, some 5 eps each")
      .by(Oracle::independent);
}

/// What holds the ends by their joints: at the tip what was applied there, at the root what balances that,
/// where the moments of a joint balance.
std::vector<Finding> ends(const Entry& entry, const std::string& what, const chain::Chain& c,
                          const chain::EndLoads& loads, const chain::Solution& found) {
  Measurement tip, root;
  const auto held = reference::holding_ends(entry, c, found.nodes);
  if (found.converged && held) {
    const Pose<double> last = chain::pose(found.nodes.back());
    const Vec3<double> force = loads.force + last.R * loads.follower_force;
    Vec3<double> moment = loads.moment + last.R * loads.follower_moment;
    for (int k = 0; k < 3; ++k) moment += Vec3<double>(last.R.col(k)).cross(loads.virial.col(k));
    const Vec3<double> about_root = moment + (last.x - c.root.x).cross(force);
    const double unit = c.section.EA * double(c.links) * 0x1p-52;
    const auto compare = [&](Measurement& out, const Vec6& end, const Vec3<double>& f,
                             const Vec3<double>& m) {
      out.include(reference::largest_entry<double>(Vec3<double>(end.head<3>() - f)) / unit, "force");
      out.include(reference::largest_entry<double>(Vec3<double>(end.tail<3>() - m)) / (unit * c.length),
                  "moment");
    };
    compare(tip, (*held)[1], force, moment);
    compare(root, (*held)[0], -force, -about_root);
  }
  const auto judged = [&](const char* end, const Measurement& off, double limit, const char* why) {
    return finding(fmt::format("chains/{}/ends/{}/{}", entry.name, what, end))
        .about("chains")
        .of(std::string(entry.name), "linear_angular")
        .measured(off)
        .in("eps of EA/h L")
        .at_most(limit, why)
        .by(Oracle::closed_form);
  };
  std::vector<Finding> out{judged("tip", tip, 64, "as of one joint's balance")};
  if (entry.has_potential(Kind::linear_angular))
    out.push_back(judged("root", root, 64 * 12, "as of one joint's balance, of twelve nodes on the way"));
  return out;
}

/// Both ends held: what the support is said to do is what the last joint needs, at the pose that was asked
/// for.
std::vector<Finding> held(const Entry& entry) {
  const chain::Chain c = generic_chain(entry);
  Pose<double> last = chain::pose(chain::at_rest(c).back());
  last.x += Vec3<double>(-0.05, 0.1, 0.03);
  last.R = so3::exp<double>({0.2, -0.3, 0.25}) * last.R;
  chain::Settings settings;
  settings.load_steps = 4;
  const chain::Held found = chain::solve_held(c, last, settings);
  Measurement away;
  if (found.solution.converged) {
    const Pose<double> tip = chain::pose(found.solution.nodes.back());
    away.include(reference::larger((tip.x - last.x).norm(), (tip.R - last.R).norm()), found.solution.outcome);
  }
  return {
      judged_balance(entry, "held", c, {found.force, {0, 0, 0}, found.moment}, found.solution),
      finding(fmt::format("chains/{}/balance/held_pose", entry.name))
          .about("chains")
          .of(std::string(entry.name), "linear_angular")
          .measured(away)
          .in("m, rad")
          .at_most(1e-13, "a running sum of 12 positions some metres from the origin, and a log and an exp")
          .by(Oracle::closed_form)};
}

std::vector<Finding> balanced(const Entry& entry) {
  std::vector<Finding> out;
  for (const auto order : {chain::NodeOrder::root_first, chain::NodeOrder::tip_first}) {
    chain::Chain c = generic_chain(entry);
    c.node_order = order;
    const chain::EndLoads loads{.force = {-0.5, 0.4, 0.7},
                                .follower_force = {0.2, -0.6, 0.3},
                                .moment = {0.5, -0.5, 0.3},
                                .follower_moment = {-0.3, 0.4, 0.6},
                                .virial = kDeadForces};
    const char* what = order == chain::NodeOrder::root_first ? "root_first" : "tip_first";
    const chain::Solution found = chain::solve(c, loads);
    out.push_back(judged_balance(entry, what, c, loads, found));
    for (const Finding& f : ends(entry, what, c, loads, found)) out.push_back(f);
  }
  for (const Finding& f : held(entry)) out.push_back(f);
  return out;
}

}  // namespace

void chain_balance(Checks& checks) {
  for (const Entry* entry : chain_formulations()) {
    checks.push_back(
        {fmt::format("chains/{}/balance", entry->name), "chains", [entry] { return balanced(*entry); }});
  }
}

}  // namespace halfway::verify
