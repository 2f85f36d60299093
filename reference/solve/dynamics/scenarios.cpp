#include "reference/solve/dynamics/drift.hpp"

#include "halfway/equilibrium.hpp"

#include <gsl/gsl_eigen.h>

#include <algorithm>
#include <cmath>
#include <memory>

namespace halfway::reference::dynamics {
namespace {

Vec3<double> vec(double x, double y, double z) { return {x, y, z}; }

Vec4 turned(const Vec3<double>& theta) {
  const auto q = so3::quaternion<double>(so3::exp<double>(theta));
  return {q.w, q.v[0], q.v[1], q.v[2]};
}

/// 1/sqrt(M) of one body's (dx, w); 0 where it cannot move.
Eigen::Matrix<double, 6, 1> inverse_root_mass(const Body& body, bool translates) {
  Eigen::Matrix<double, 6, 1> out = Eigen::Matrix<double, 6, 1>::Zero();
  if (body.clamped) return out;
  if (translates) out.head<3>().setConstant(1 / std::sqrt(body.mass));
  out.tail<3>() = body.inertia.cwiseSqrt().cwiseInverse();
  return out;
}

/// Two bodies at the same place and one joint.
Scenario pair(const char* name, const char* title) {
  return {name, title, {Joint{}}, std::vector<Body>(2), State(2)};
}

/// Where a curve of constant curvature (1/m, axes along it) is after the length s, m; its tangent is axis 1.
Pose<double> along(const Pose<double>& from, const Vec3<double>& curvature, double s) {
  const Vec3<double> turn = s * curvature;
  return {from.x + from.R * (s * so3::gamma<double>(turn).col(0)), from.R * so3::exp<double>(turn)};
}

/// Of the bodies where no joint is strained: each joint's node b is placed by its node a.
Eigen::MatrixXd tangent_at_rest(const Entry& entry, const Scenario& scenario) {
  const long count = 6 * long(scenario.bodies.size());
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(count, count);
  std::vector<Pose<double>> rest(scenario.bodies.size());
  for (const Joint& j : scenario.joints) {
    rest[j.b] = unstrained(j.spec.a, j.spec.b, rest[j.a]);
    const Eigen::MatrixXd of_nodes = node_loads<double>(entry, j.spec, rest[j.a], rest[j.b], true).tangent;
    const long at[] = {6 * long(j.a), 6 * long(j.b)};
    for (int r = 0; r < 2; ++r) {
      for (int c = 0; c < 2; ++c) K.block<6, 6>(at[r], at[c]) += of_nodes.block<6, 6>(6 * r, 6 * c);
    }
  }
  return K;
}

}  // namespace

Scenario clamped_scenario(const Entry& entry) {
  Scenario s = pair("clamped", "one body on an angular joint to a clamped node");
  JointSpec& spec = s.joints.front().spec;
  spec.xi = entry.probe_xi;
  spec.law = LinearSpec{vec(1, 10, 100).asDiagonal(), false};
  s.bodies = {Body{1, vec(1, 1, 1), true}, Body{1, vec(1, 2, 2.5), false}};
  s.start[1].q = turned(vec(0.45, 0.16, 0.05));
  set_motion(s.bodies[1], vec(0, 0, 0), vec(0.1, -0.15, 0.2), s.start[1]);
  return s;
}

Scenario free_scenario(const Entry& entry) {
  Scenario s = pair("free", "two free bodies on a linear/angular joint off their centres");
  JointSpec& spec = s.joints.front().spec;
  spec.kind = Kind::linear_angular;
  spec.xi = entry.probe_xi;
  Eigen::VectorXd k(6);
  k << 6, 20, 40, 1, 5, 20;
  spec.law = LinearSpec{k.asDiagonal(), false};
  spec.a.o = vec(0.3, 0.1, -0.2);
  spec.b.o = vec(-0.25, 0.15, 0.1);
  s.bodies = {Body{2, vec(1.5, 2, 2.6), false}, Body{1, vec(0.8, 1.1, 1.3), false}};
  s.start[1].q = turned(vec(0.45, 0.16, 0.05));
  const Vec3<double> apart = vec(0.12, -0.08, 0.04);  // of the joint points, in the axes of a
  s.start[1].x = spec.a.o + apart - orientation(s.start[1].q) * spec.b.o;
  const Vec3<double> w = vec(0.12, -0.08, 0.15);  // both turn together
  set_motion(s.bodies[0], vec(0, 0, 0), w, s.start[0]);
  set_motion(s.bodies[1], w.cross(s.start[1].x), w + vec(0.1, 0.05, -0.1), s.start[1]);
  const Vec3<double> drift = (s.start[0].p + s.start[1].p) / (s.bodies[0].mass + s.bodies[1].mass);
  for (std::size_t i = 0; i < 2; ++i) s.start[i].p -= s.bodies[i].mass * drift;
  return s;
}

Scenario chain_scenario(const Entry& entry) {
  constexpr std::size_t kLinks = 16;
  constexpr double kLength = 1, h = kLength / kLinks, kMassPerLength = 1;
  const Vec3<double> at_rest = vec(0.5, 0.9, -0.7), at_start = at_rest + vec(0.9, 1.6, -1.1);  // curvatures
  const Vec3<double> spin = vec(0.4, -0.5, 0.7);                                               // rad/s
  Scenario s{"chain", "sixteen free links, curved, a joint between each two", {}, {}, State(kLinks)};
  JointSpec spec;
  spec.kind = Kind::linear_angular;
  spec.xi = entry.probe_xi;
  if (entry.needs_length) spec.length = h, spec.axis = 1;
  Eigen::VectorXd k(6);
  k << 500, 300, 200, 0.8, 1, 4;  // EA, GA, GJ, EI
  spec.law = LinearSpec{(k / h).asDiagonal(), false};
  const Mat3<double> section = so3::exp<double>(vec(0.6, 0, 0));  // principal axes of EI in those of inertia
  const auto end = [&](double way) -> JointEnd<double> {
    const Pose<double> at = along({}, at_rest, way);
    return {at.x, at.R * section};
  };
  spec.a = end(h / 2), spec.b = end(-h / 2);
  const double m = kMassPerLength * h;
  s.bodies.assign(kLinks, {m, m * vec(0.015, 0.01, 0.012), false});
  Pose<double> pose;
  for (std::size_t i = 0; i < kLinks; ++i) {
    if (i > 0) s.joints.push_back({spec, i - 1, i});
    const auto q = so3::quaternion<double>(pose.R);
    s.start[i].x = pose.x, s.start[i].q << q.w, q.v;
    set_motion(s.bodies[i], vec(0.2, -0.3, 0.1) + spin.cross(pose.x), spin, s.start[i]);
    pose = along(pose, at_start, h);
  }
  return s;
}

std::vector<double> frequencies(const Entry& entry, const Scenario& scenario) {
  const long count = 6 * long(scenario.bodies.size());
  Eigen::MatrixXd K = tangent_at_rest(entry, scenario);
  if (!K.allFinite()) return {};
  Eigen::VectorXd scale(count);
  const bool translates = scenario.joints.front().spec.kind != Kind::angular;
  for (std::size_t i = 0; i < scenario.bodies.size(); ++i)
    scale.segment<6>(6 * long(i)) = inverse_root_mass(scenario.bodies[i], translates);
  K = scale.asDiagonal() * K * scale.asDiagonal();
  Eigen::VectorXd squares(count);
  gsl_matrix_view matrix = gsl_matrix_view_array(K.data(), std::size_t(count), std::size_t(count));
  gsl_vector_view values = gsl_vector_view_array(squares.data(), std::size_t(count));
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> work(
      gsl_eigen_symm_alloc(std::size_t(count)), &gsl_eigen_symm_free);
  gsl_eigen_symm(&matrix.matrix, &values.vector, work.get());
  std::vector<double> out;
  constexpr double kRigid = 1e-9;  // of the stiffest: rounding leaves 1e-15
  for (double square : squares) {
    if (square > kRigid * squares.maxCoeff()) out.push_back(std::sqrt(square));
  }
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace halfway::reference::dynamics
