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

}  // namespace

Scenario clamped_scenario(const Entry& entry) {
  Scenario s{"clamped", "one body on an angular joint to a clamped node", {}, {}, {}};
  s.spec.xi = entry.probe_xi;
  s.spec.law = LinearSpec{vec(1, 10, 100).asDiagonal(), false};
  s.bodies = {Body{1, vec(1, 1, 1), true}, Body{1, vec(1, 2, 2.5), false}};
  s.start[1].q = turned(vec(0.45, 0.16, 0.05));
  set_motion(s.bodies[1], vec(0, 0, 0), vec(0.1, -0.15, 0.2), s.start[1]);
  return s;
}

Scenario free_scenario(const Entry& entry) {
  Scenario s{"free", "two free bodies on a linear/angular joint off their centres", {}, {}, {}};
  s.spec.kind = Kind::linear_angular;
  s.spec.xi = entry.probe_xi;
  Eigen::VectorXd k(6);
  k << 6, 20, 40, 1, 5, 20;
  s.spec.law = LinearSpec{k.asDiagonal(), false};
  s.spec.a.o = vec(0.3, 0.1, -0.2);
  s.spec.b.o = vec(-0.25, 0.15, 0.1);
  s.bodies = {Body{2, vec(1.5, 2, 2.6), false}, Body{1, vec(0.8, 1.1, 1.3), false}};
  s.start[1].q = turned(vec(0.45, 0.16, 0.05));
  const Vec3<double> apart = vec(0.12, -0.08, 0.04);  // of the joint points, in the axes of a
  s.start[1].x = s.spec.a.o + apart - orientation(s.start[1].q) * s.spec.b.o;
  const Vec3<double> w = vec(0.12, -0.08, 0.15);  // both turn together
  set_motion(s.bodies[0], vec(0, 0, 0), w, s.start[0]);
  set_motion(s.bodies[1], w.cross(s.start[1].x), w + vec(0.1, 0.05, -0.1), s.start[1]);
  const Vec3<double> drift = (s.start[0].p + s.start[1].p) / (s.bodies[0].mass + s.bodies[1].mass);
  for (std::size_t i = 0; i < 2; ++i) s.start[i].p -= s.bodies[i].mass * drift;
  return s;
}

std::vector<double> frequencies(const Entry& entry, const Scenario& scenario) {
  const Pose<double> a{};
  const Pose<double> b = unstrained(scenario.spec.a, scenario.spec.b, a);
  Eigen::MatrixXd K = node_loads<double>(entry, scenario.spec, a, b, true).tangent;
  if (!K.allFinite()) return {};
  Eigen::VectorXd scale(12);
  const bool translates = scenario.spec.kind != Kind::angular;
  scale << inverse_root_mass(scenario.bodies[0], translates),
      inverse_root_mass(scenario.bodies[1], translates);
  K = scale.asDiagonal() * K * scale.asDiagonal();
  Eigen::VectorXd squares(12);
  gsl_matrix_view matrix = gsl_matrix_view_array(K.data(), 12, 12);
  gsl_vector_view values = gsl_vector_view_array(squares.data(), 12);
  const std::unique_ptr<gsl_eigen_symm_workspace, decltype(&gsl_eigen_symm_free)> work(
      gsl_eigen_symm_alloc(12), &gsl_eigen_symm_free);
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
