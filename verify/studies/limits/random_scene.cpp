#include "verify/studies/limits/random_scene.hpp"

#include "reference/face/instantiations.hpp"
#include "reference/record/worst.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace halfway::reference {
namespace {

double power(Generator& random, double low, double high) { return std::pow(10, random.uniform(low, high)); }
bool chance(Generator& random, double share) { return random.uniform(0, 1) < share; }
/// Its direction is drawn in here: after a length that is drawn in the call.
Vec3<double> arrow(Generator& random, double length) { return length * random.direction(); }

Eigen::VectorXd stiffnesses(Generator& random, int n) {
  const double base = power(random, -3, 1), spread = random.uniform(0, 8);
  Eigen::VectorXd k(n);
  for (double& x : k) x = base * power(random, 0, spread);
  return k;
}

/// Symmetric positive definite with these eigenvalues and no axis aligned.
Eigen::MatrixXd full(Generator& random, const Eigen::VectorXd& eigenvalues) {
  const auto n = eigenvalues.size();
  Eigen::MatrixXd basis(n, n), K = Eigen::MatrixXd::Zero(n, n);
  for (double& x : basis.reshaped()) x = random.uniform(-1, 1);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < i; ++j) basis.col(i) -= basis.col(j).dot(basis.col(i)) * basis.col(j);
    basis.col(i).normalize();
    K += eigenvalues[i] * basis.col(i) * basis.col(i).transpose();
  }
  return (K + K.transpose()) / 2;
}

double coefficient(Generator& random, double k) {
  const double size = power(random, -1, 2);
  return k * size * random.uniform(-1, 1);
}

LawSpec law(Generator& random, const Entry& entry, const Eigen::VectorXd& k) {
  const auto n = k.size();
  const double which = random.uniform(0, 1);
  if (which < 0.3) {
    PolynomialSpec out{k, Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
      out.k3[i] = coefficient(random, k[i]);
      if (chance(random, 0.5)) out.k5[i] = coefficient(random, k[i]);
    }
    return out;
  }
  LinearSpec out;
  out.is_compliance = chance(random, 0.3);
  const Eigen::VectorXd values = out.is_compliance ? Eigen::VectorXd(k.cwiseInverse()) : k;
  out.matrix = which < 0.6 ? Eigen::MatrixXd(values.asDiagonal()) : full(random, values);
  if (entry.block_diagonal_law_only && n == 6) {
    out.matrix.topRightCorner(3, 3).setZero();
    out.matrix.bottomLeftCorner(3, 3).setZero();
  }
  return out;
}

JointEnd<double> end(Generator& random) {
  JointEnd<double> out;
  if (chance(random, 0.3)) return out;
  out.o = arrow(random, power(random, -6, 3));
  out.H = random.rotation(0, std::numbers::pi);
  return out;
}

SceneLoad load(Generator& random, Kind kind, double stiffness) {
  const double type = random.uniform(0, 1);
  const double size = chance(random, 0.05) ? power(random, -150, 150) : power(random, -12, 6);
  SceneLoad out;
  out.value = arrow(random, size * stiffness);
  if (kind == Kind::linear || type < 0.4) {
    out.type = LoadType::fixed_force;
    if (chance(random, 0.5)) out.point = arrow(random, power(random, -6, 3));
  } else {
    out.type = type < 0.7 ? LoadType::fixed_moment : LoadType::follower_moment;
  }
  return out;
}

Setting setting(Generator& random) {
  Setting out;
  out.nodes_exchanged = chance(random, 0.5);
  if (chance(random, 0.5)) return out;
  out.frame_turn = arrow(random, random.uniform(0, std::numbers::pi));
  out.frame_shift = arrow(random, power(random, -3, 3));
  return out;
}

}  // namespace

RandomScene random_scene(Generator& random, const Entry& entry) {
  RandomScene out;
  out.scene.name = "random";
  const double kind = random.uniform(0, 3);
  JointSpec& joint = out.scene.joint;
  joint.kind = kind < 1 ? Kind::angular : kind < 2 ? Kind::linear : Kind::linear_angular;
  const Eigen::VectorXd k = stiffnesses(random, strain_count(joint.kind));
  joint.law = law(random, entry, k);
  joint.a = end(random);
  joint.b = end(random);
  out.xi = entry.needs_xi ? random.uniform(-0.5, 1.5) : entry.probe_xi;
  const double largest = k.maxCoeff(), least = k.minCoeff();
  const double stiffness = least * std::pow(largest / least, random.uniform(0, 1));
  const int loads = joint.kind == Kind::linear ? 1 : 1 + int(random.uniform(0, 3));
  for (int i = 0; i < loads; ++i) out.scene.loads.push_back(load(random, joint.kind, stiffness));
  out.setting = setting(random);
  return out;
}

double distance_to_equilibrium(const RandomScene& random, const Entry& entry, const Outcome<double>& state) {
  const EquilibriumProblem<Real50> problem(random.scene, entry, random.xi, random.setting);
  Pose<Real50> from = cast<Real50>(state.joint);
  from.R = so3::matrix(so3::quaternion(from.R));
  const Outcome<Real50> exact = problem.equilibrium_near(from, Real50(state.factor));
  if (exact.status != Status::converged) return std::nan("");
  const Real50 moved = (exact.joint.x - from.x).norm() / (Real50(1) + from.x.norm());
  const Real50 turned = (exact.joint.R - from.R).norm();
  return double(moved + turned);
}

bool is_finite(const RandomScene& random, const Entry& entry, const Outcome<double>& state) {
  const Pose<double> b =
      EquilibriumProblem<double>(random.scene, entry, random.xi, random.setting).node(state.joint);
  return b.x.allFinite() && b.R.allFinite() && std::isfinite(state.factor) && std::isfinite(state.residual);
}

}  // namespace halfway::reference
