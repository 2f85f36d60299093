// rod4 and rod34 against the rod itself: orders of what they miss, and how much of a rotation that is.
#include "reference/scene/scene.hpp"
#include "reference/solve/path.hpp"
#include "reference/truth/rod/rod.hpp"
#include "verify/oracle/property.hpp"
#include "verify/oracle/saboteurs/tap.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace halfway::verify {
namespace {

using reference::Generator;

/// A rod's angular stiffnesses, and for loads of one per cent of a turn and less the size of them, rad: |K^-1
/// m|.
struct AngularRod {
  const char* name;
  double k[3];
  double load;
};
constexpr AngularRod kRods[] = {
    {"1_2_3", {1, 2, 3}, 0.2}, {"c3", {627.58, 69.523, 2496.04}, 0.03}, {"1_10_100", {1, 10, 100}, 0.01}};

Draft of_rod(const std::string& formulation, const std::string& what, Kind kind) {
  return finding(fmt::format("rod_joints/{}/{}", formulation, what))
      .of(formulation, to_string(kind))
      .about("rod_joints");
}

/// A joint whose law has principal axes that are not its own, with frames turned on both nodes.
JointSpec turned_rod(const Entry& entry, const AngularRod& rod) {
  JointSpec spec;
  static_cast<Parameters&>(spec) = entry.probe;
  const Mat3<double> Q = so3::exp<double>({0.4, -0.7, 0.2});
  const Mat3<double> K = Q * Vec3<double>(rod.k[0], rod.k[1], rod.k[2]).asDiagonal() * Q.transpose();
  spec.law = reference::LinearSpec{(K + K.transpose()) / 2, false};
  spec.a.H = so3::exp<double>({0.3, 0.9, -0.5});
  spec.b.H = so3::exp<double>({-0.8, 0.1, 0.6});
  return spec;
}

/// Of the moment that holds the tip of the rod where a moment turns it: what the joint's own is off.
/// @param turn  K^-1 m in joint axes, rad
double moment_off(const Entry& entry, const JointSpec& spec, const Vec3<double>& turn) {
  const Mat3<double> K = std::get<reference::LinearSpec>(spec.law).matrix;
  const Vec3<double> m = K * turn;
  Pose<double> a, b;
  a.R = so3::exp<double>({-0.2, 0.5, 0.7});
  b.R = a.R * spec.a.H * tapped(reference::rod::end_rotation(K, m)) * spec.b.H.transpose();
  return (entry.in_double.angular(spec, a, b, false).m_b - a.R * spec.a.H * m).norm();
}

/// The power of the load with which the moment is off, of eight directions together.
double order_of_moment(const Entry& entry, const AngularRod& rod) {
  const JointSpec spec = turned_rod(entry, rod);
  Generator g(417);
  double large = 0, small = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3<double> turn = rod.load * g.direction();
    large += std::pow(moment_off(entry, spec, turn), 2);
    small += std::pow(moment_off(entry, spec, turn / 2), 2);
  }
  return std::log2(large / small) / 2;
}

std::vector<Finding> orders_of_moment(const std::string& formulation, double expected) {
  const Entry& entry = *reference::find_formulation(formulation);
  std::vector<Finding> out;
  for (const AngularRod& rod : kRods) {
    out.push_back(
        of_rod(formulation, fmt::format("order_of_moment_{}", rod.name), Kind::angular)
            .measured(order_of_moment(entry, rod), fmt::format("|K^-1 m| = {} and half of it", rod.load))
            .in("order")
            .equal(expected, 0.05,
                   "the Magnus series of the rod: orders go by two, and the next is a hundredth of this one; "
                   "a joint in a node's frame misses the second, a half-way one the third, rod4 the fifth")
            .by(Oracle::independent));
  }
  return out;
}

/// What the joint at mid-length misses of the tip's rotation and place under a dead force there, relative to
/// the rotation.
double pose_off(const Entry& entry, double length) {
  const Vec3<double> bending(0.8, 1, 4), stretching = Vec3<double>::Constant(1e6), force(-0.5, 1.1, 0.8);
  namespace rod = reference::rod;
  const rod::Rod truth = rod::straight(length, rod::of_stiffness(bending, stretching));
  rod::Loads loads;
  loads.force = force;
  const rod::Tip exact = rod::solve(truth, loads);
  reference::Scene scene;
  // Joint axes: the rod's own, named anew, so that it runs against axis 2 from a to b.
  Mat3<double> H;
  H << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  const auto across = [&](double EI) {
    return 1 / (std::pow(length, 3) / (12 * EI) + length / stretching[1]);
  };
  const double K[] = {stretching[0] / length, across(bending[2]),  across(bending[1]),
                      bending[0] / length,    bending[1] / length, bending[2] / length};
  constexpr int kAxisOf[] = {1, 0, 2};
  Eigen::VectorXd diagonal(6);
  for (int i = 0; i < 6; ++i) diagonal[i / 3 * 3 + kAxisOf[i % 3]] = K[i];
  JointSpec& spec = scene.joint;
  spec.kind = Kind::linear_angular;
  spec.length = length, spec.axis = -2;
  spec.law = reference::LinearSpec{diagonal.asDiagonal(), false};
  spec.a = {Vec3<double>(length / 2, 0, 0), H};
  spec.b = {Vec3<double>(-length / 2, 0, 0), H};
  scene.loads = {{reference::LoadType::fixed_force, force}};
  reference::Path<double> path(scene, entry, entry.probe.xi);
  if (path.advance(1).status != Status::converged) return std::nan("");
  const Pose<double> tip = path.node();
  const Mat3<double> R = tapped(exact.R);
  const double turn = so3::log<double>(tip.R.transpose() * R).norm();
  return std::hypot(turn, (tip.x - tapped(exact.x)).norm() / length) / so3::log<double>(R).norm();
}

/// Under a dead force at the tip the strain of half a rod is half; what is missed of it falls as a power.
std::vector<Finding> order_at_tip(const std::string& formulation, double expected) {
  const Entry& entry = *reference::find_formulation(formulation);
  const double whole = pose_off(entry, 0.4), half = pose_off(entry, 0.2);
  return {of_rod(formulation, "order_at_tip", Kind::linear_angular)
              .measured(std::log2(whole / half),
                        fmt::format("{:.3g} of the rotation, {:.3g} at half the length", whole, half))
              .in("order")
              .equal(expected, 0.1,
                     "the strains of the rod to the second order and its energy to the fourth; the next "
                     "order is the "
                     "rotation squared, a fortieth")
              .by(Oracle::independent)};
}

}  // namespace

void rod_joints(Checks& checks) {
  const auto add = [&](const char* formulation, double order) {
    checks.push_back({fmt::format("rod_joints/{}/order_of_moment", formulation), "",
                      [=] { return orders_of_moment(formulation, order); }});
  };
  add("attached_a", 2);
  for (const char* half_way : {"invariant", "potential", "conformal", "cayley"}) add(half_way, 3);
  add("rod4", 5);
  add("rod34", 5);
  checks.push_back({"rod_joints/potential/order_at_tip", "", [] { return order_at_tip("potential", 2); }});
  checks.push_back({"rod_joints/rod34/order_at_tip", "", [] { return order_at_tip("rod34", 4); }});
}

}  // namespace halfway::verify
