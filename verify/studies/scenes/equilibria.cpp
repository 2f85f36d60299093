// The solver's loads and unknowns, against equilibria that have closed forms.
#include "reference/numbers/zeros.hpp"
#include "reference/record/worst.hpp"
#include "verify/oracle/scene_access.hpp"

#include <cmath>
#include <limits>

namespace halfway::verify {
namespace {

using reference::LoadType;
using reference::Scene;
using reference::SceneLoad;

Scene posed(Kind kind, const Eigen::VectorXd& stiffness, const SceneLoad& load) {
  Scene s;
  s.name = "posed";
  s.joint.kind = kind;
  s.joint.law = reference::LinearSpec{stiffness.asDiagonal(), false};
  s.loads = {load};
  return s;
}

/// What rounding leaves of a solution of order 1: the largest load, turned into the softest direction, is
/// wrong by an eps of itself each time it is multiplied, eight times in all.
double floor_of(const Scene& s) {
  const auto& K = std::get<reference::LinearSpec>(s.joint.law).matrix;
  const double magnified = reference::largest_entry<double>(s.loads.front().value) / K.diagonal().minCoeff();
  return reference::larger(1e-14, 8 * std::numeric_limits<double>::epsilon() * magnified);
}

/// Largest difference of one solution and its closed form, relative.
Finding against(const std::string& name, const Scene& s, const char* formulation, const char* output,
                double expected, const std::string& reason) {
  reference::Path<double> path(s, *reference::find_formulation(formulation), 0.5);
  return finding("equilibria/" + name + "/" + output)
      .of(formulation)
      .about("equilibria")
      .measured(path.advance(1).status == Status::converged ? path.output(output) : std::nan(""))
      .equal(expected, floor_of(s),
             reason +
                 "; tens of eps of a solution of order 1, or eight of the largest load over the softest "
                 "stiffness")
      .by(Oracle::closed_form);
}

/// Law and moment both fixed in node b: theta = K^-1 m, at any size.
std::vector<Finding> follower_moment() {
  const Scene s =
      posed(Kind::angular, Eigen::Vector3d(1, 10, 100), {LoadType::follower_moment, {0.5, 4, 60}});
  const std::string reason = "R_b K theta = R_b m";
  return {against("follower_moment", s, "attached_b", "theta_x", 0.5, reason),
          against("follower_moment", s, "attached_b", "theta_y", 0.4, reason),
          against("follower_moment", s, "attached_b", "theta_z", 0.6, reason)};
}

/// k theta = moment cos(theta), by bisection: a force at the end of an arm.
double turned_by_arm(double k, double moment) {
  return reference::last_where([&](double t) { return k * t < moment * std::cos(t); }, 0.0, 1.5, 60);
}

std::vector<Finding> force_on_arm() {
  const Scene s =
      posed(Kind::angular, Eigen::Vector3d(2, 2, 2), {LoadType::fixed_force, {0, 1.5, 0}, {2, 0, 0}});
  return {
      against("force_on_arm", s, "invariant", "theta_z", turned_by_arm(2, 3), "k theta = F L cos(theta)")};
}

/// A dead load at the node and a push at a point above it. Through an isotropic stiffness a force has no
/// moment of its own, so the push alone turns the node.
std::vector<Finding> two_forces() {
  Scene s = posed(Kind::linear_angular, (Eigen::VectorXd(6) << 1e6, 1e6, 1e6, 200, 200, 200).finished(),
                  {LoadType::fixed_force, {0, 0, -300}});
  s.loads.push_back({LoadType::fixed_force, {100, 0, 0}, {0, 0, 0.5}});
  return {against("two_forces", s, "invariant", "theta_y", turned_by_arm(200, 50),
                  "k theta = F L cos(theta), whatever the other force")};
}

/// A linear joint whose node keeps its orientation: three displacements.
std::vector<Finding> held_orientation() {
  const Scene s = posed(Kind::linear, Eigen::Vector3d(2, 4, 8), {LoadType::fixed_force, {1, 1, 1}});
  return {against("held_orientation", s, "invariant", "u_x", 0.5, "u = K^-1 f"),
          against("held_orientation", s, "invariant", "u_y", 0.25, "u = K^-1 f"),
          against("held_orientation", s, "invariant", "u_z", 0.125, "u = K^-1 f")};
}

/// A path that cannot go on says so: JOINTC cannot carry more than k about one axis [53].
std::vector<Finding> beyond_the_limit() {
  const Scene s = posed(Kind::angular, Eigen::Vector3d(1, 1, 1), {LoadType::fixed_moment, {1, 0, 0}});
  reference::Path<double> path(s, *reference::find_formulation("jointc"), 0.5);
  const auto& state = path.advance(1);
  return {
      finding("equilibria/beyond_the_limit/factor")
          .of("jointc")
          .about("equilibria")
          .measured(state.status == Status::converged ? std::nan("") : state.factor)
          .equal(
              0.5, 1e-6,
              "m = k sin(phi) cos(phi) has its largest value k/2 at phi = pi/4; the last load step is 1e-9, "
              "and near a limit point the reached load falls short of it by the square of the last rotation "
              "step")
          .by(Oracle::closed_form)};
}

}  // namespace

void equilibria(Checks& checks) {
  checks.push_back({"equilibria/follower_moment", "cases", follower_moment});
  checks.push_back({"equilibria/force_on_arm", "cases", force_on_arm});
  checks.push_back({"equilibria/two_forces", "cases", two_forces});
  checks.push_back({"equilibria/held_orientation", "cases", held_orientation});
  checks.push_back({"equilibria/beyond_the_limit", "cases", beyond_the_limit});
}

}  // namespace halfway::verify
