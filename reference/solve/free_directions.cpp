#include "reference/solve/free_directions.hpp"

#include "reference/record/worst.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace halfway::reference {
namespace {

/// A stiffness below this share of its block's largest is none.
constexpr double kNone = 1e-13;

/// What a load may do on a free direction: rounding of frames and offsets.
constexpr double kNothing = 1e-12;

const LinearSpec* stiffness_of(const Scene& scene) {
  const auto* linear = std::get_if<LinearSpec>(&scene.joint.law);
  return linear && !linear->is_compliance ? linear : nullptr;
}

/// 1 / sqrt of each block's largest diagonal entry: strains times it compare m with rad.
Eigen::VectorXd units(const Eigen::MatrixXd& K) {
  Eigen::VectorXd out(K.rows());
  for (Eigen::Index i = 0; i < K.rows(); i += 3) {
    const double largest = K.diagonal().segment<3>(i).maxCoeff();
    out.segment<3>(i).setConstant(largest > 0 ? 1 / std::sqrt(largest) : 1);
  }
  return out;
}

/// Strains that meet no stiffness, one a column, in m and rad; no column when there is none.
Eigen::MatrixXd free_strains(const Eigen::MatrixXd& K) {
  const Eigen::VectorXd scale = units(K);
  Eigen::FullPivLU<Eigen::MatrixXd> lu(scale.asDiagonal() * K * scale.asDiagonal());
  lu.setThreshold(kNone);
  if (lu.dimensionOfKernel() == 0) return Eigen::MatrixXd(K.rows(), 0);
  return scale.asDiagonal() * lu.kernel();
}

/// What the scene's loads do on the strains of the joint at rest, N and N m, in its axes.
Eigen::VectorXd load_at_rest(const Scene& scene) {
  const JointSpec& joint = scene.joint;
  // Node a at the origin in global axes: the joint's axes are H_a, node b stands at H_a H_b^T.
  const Mat3<double> R_b = joint.a.H * joint.b.H.transpose();
  Vec3<double> f = Vec3<double>::Zero(), m = Vec3<double>::Zero();
  for (const SceneLoad& load : scene.loads) {
    const Vec3<double> value = follows(load.type) ? Vec3<double>(R_b * load.value) : load.value;
    if (is_force(load.type)) {
      f += value;
      m += (R_b * (load.point - joint.b.o)).cross(value);
    } else {
      m += value;
    }
  }
  Eigen::VectorXd all(6);
  all << joint.a.H.transpose() * f, joint.a.H.transpose() * m;
  if (joint.kind == Kind::linear_angular) return all;
  return joint.kind == Kind::linear ? all.head(3) : all.tail(3);
}

}  // namespace

std::optional<Scene> held(const Scene& scene, double hold) {
  const LinearSpec* law = stiffness_of(scene);
  if (!law) return std::nullopt;
  const Eigen::MatrixXd free = free_strains(law->matrix);
  if (free.cols() == 0) return std::nullopt;
  const Eigen::VectorXd stiff = units(law->matrix).cwiseInverse();
  const Eigen::MatrixXd carried = stiff.cwiseAbs2().asDiagonal() * free;
  Scene out = scene;
  out.joint.law = LinearSpec{law->matrix + hold * carried * carried.transpose(), false};
  return out;
}

bool agree(const Curve& a, const Curve& b) {
  if (a.rows.empty() || b.rows.empty()) return false;
  const auto &x = a.rows.back(), &y = b.rows.back();
  double largest = 0, difference = 0;
  for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
    if (i > 0) keep_largest(largest, std::abs(x[i]));  // the first is the load factor
    keep_largest(difference, std::abs(x[i] - y[i]));
  }
  return x.size() == y.size() && difference <= 1e-9 * largest;
}

std::optional<std::string> works_on_free_direction(const Scene& scene) {
  const LinearSpec* law = stiffness_of(scene);
  if (!law) return std::nullopt;
  const Eigen::MatrixXd free = free_strains(law->matrix);
  const Eigen::VectorXd load = load_at_rest(scene);
  const Eigen::VectorXd scale = units(law->matrix);
  for (Eigen::Index i = 0; i < free.cols(); ++i) {
    const double work = std::abs(load.dot(free.col(i)));
    if (work <= kNothing * load.cwiseAbs().cwiseProduct(scale).sum()) continue;
    const Eigen::VectorXd n = (free.col(i) / free.col(i).cwiseAbs().maxCoeff()).array() + 0.0;  // no -0
    return fmt::format(
        "the load works on a direction without stiffness, ({:.3g}) in the joint's strains: nothing "
        "balances it there",
        fmt::join(n, ", "));
  }
  return std::nullopt;
}

}  // namespace halfway::reference
