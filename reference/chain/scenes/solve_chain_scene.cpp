#include "reference/chain/scenes/solve_chain_scene.hpp"

#include "reference/record/worst.hpp"
#include "reference/scene/joint/convexity.hpp"

#include <fmt/format.h>

#include <string_view>

namespace halfway::reference {
namespace {

/// x, y, z or theta_x, theta_y, theta_z.
double output_of(const Pose<double>& tip, const Vec3<double>& theta, std::string_view output) {
  const int axis = output.back() - 'x';
  return output.size() == 1 ? tip.x[axis] : theta[axis];
}

void add_shape(const ChainScene& scene, double factor, std::vector<chain::Node> nodes, double error,
               ChainAnswer& out) {
  const Pose<double> tip = chain::pose(nodes.back());
  const Vec3<double> theta = so3::log(tip.R);
  std::vector<double> row{factor};
  for (const std::string& output : scene.outputs) row.push_back(output_of(tip, theta, output));
  out.curve.rows.push_back(std::move(row));
  out.curve.errors.push_back(error);
  out.shapes.push_back({factor, std::move(nodes)});
}

chain::Solution solved(const ChainScene& scene, const chain::Chain& chain, double factor,
                       const ChainTold& told) {
  chain::Settings settings;
  settings.progress = told;
  if (!scene.held) return chain::solve(chain, scaled(scene.loads, factor), settings);
  settings.load_steps = scene.held_steps;
  return chain::solve_held(chain, *scene.held, settings).solution;
}

/// The largest rotation of a joint, rad. Between its frames it is the same as between its nodes, seen from
/// where they are at rest: the angle of H_a^T R H_b is that of R H_b H_a^T.
double largest_turn(const std::vector<chain::Node>& nodes, const std::vector<chain::Node>& rest) {
  double out = 0;
  const auto between = [](const std::vector<chain::Node>& of, std::size_t i) -> Mat3<double> {
    return chain::pose(of[i]).R.transpose() * chain::pose(of[i + 1]).R;
  };
  for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
    keep_largest(out, so3::log<double>(between(rest, i).transpose() * between(nodes, i)).norm());
  return out;
}

}  // namespace

std::string beyond_series(const Entry& entry, const chain::Chain& chain,
                          const std::vector<chain::Node>& nodes) {
  if (!entry.convex_radius) return "";
  const double h = chain.length / double(chain.links);
  const Vec3<double> k = Vec3<double>(chain.section.GJ, chain.section.EI2, chain.section.EI3) / h;
  const double radius = entry.convex_radius(Eigen::MatrixXd(k.asDiagonal()));
  const double turn = largest_turn(nodes, chain::at_rest(chain));
  return turn <= radius ? "" : "a joint's " + beyond_convexity(entry, turn, radius);
}

chain::EndLoads scaled(const chain::EndLoads& loads, double factor) {
  return {factor * loads.force, factor * loads.follower_force, factor * loads.moment,
          factor * loads.follower_moment, factor * loads.virial};
}

chain::Chain chain_of(const ChainScene& scene, const Choice& choice) {
  chain::Chain chain = scene.chain;
  chain.formulation = choice.entry->name;
  if (choice.entry->needs_xi) chain.xi = choice.xi;
  return chain;
}

ChainAnswer solve_chain_scene(const ChainScene& scene, const Choice& choice, const ChainTold& told) {
  ChainAnswer out{empty_curve(scene, choice), {}};
  const auto watched = [&](int done, int most) {
    out.stopped = told && !told(done, most);
    return !out.stopped;
  };
  const chain::Chain chain = chain_of(scene, choice);
  add_shape(scene, 0, chain::at_rest(chain), 0, out);
  for (int i = 1; i <= scene.points; ++i) {
    const double factor = scene.factor_end * i / scene.points;
    chain::Solution found = solved(scene, chain, factor, watched);
    out.curve.iterations += int(found.iterations.size());
    out.curve.residual = found.imbalance;
    out.curve.converged = found.converged;
    out.curve.outcome = found.outcome;
    const std::string why =
        found.converged ? beyond_series(*choice.entry, chain, found.nodes) : found.outcome;
    if (!why.empty()) {
      out.curve.converged = false;
      out.curve.cause = why;
      out.curve.outcome = fmt::format("stopped at load factor {:g}: {}", factor, why);
      return out;
    }
    add_shape(scene, factor, std::move(found.nodes), found.tip_error * chain.length, out);
  }
  return out;
}

}  // namespace halfway::reference
