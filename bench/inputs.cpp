#include "bench/inputs.hpp"

#include "reference/random.hpp"

#include <cmath>

namespace halfway::bench {
namespace {

using reference::Generator;

/// Sum of springs of stiffness 1 to 100 along random directions: positive definite, nothing aligned.
Eigen::MatrixXd stiffness(Generator& g, int n) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int spring = 0; spring < n; ++spring) {
    Eigen::VectorXd v(n);
    for (double& x : v) x = g.uniform(-1, 1);
    K += std::pow(100.0, double(spring) / (n - 1)) * v * v.transpose();
  }
  return K;
}

}  // namespace

Inputs inputs(Kind kind, double xi, bool block_diagonal) {
  Generator g(2011);
  Inputs in;
  in.spec.kind = kind;
  in.spec.xi = xi;
  Eigen::MatrixXd K = stiffness(g, strain_count(kind));
  if (block_diagonal && kind == Kind::linear_angular) {
    K.topRightCorner(3, 3).setZero();
    K.bottomLeftCorner(3, 3).setZero();
  }
  in.spec.law = reference::LinearSpec{K, false};
  in.spec.a = {g.vector(0.5), g.rotation(0.5, 1.5)};
  in.spec.b = {g.vector(0.5), g.rotation(0.5, 1.5)};
  for (int i = 0; i < kPoses; ++i) {
    const Pose<double> a{g.vector(1), g.rotation(0, 3)};
    const double phi = 1e-3 * std::pow(3e3, g.uniform(0, 1));
    const Mat3<double> R_b =
        a.R * in.spec.a.H * so3::exp<double>(phi * g.direction()) * in.spec.b.H.transpose();
    const Vec3<double> d = g.vector(0.3);
    in.a.push_back(a);
    in.b.push_back({a.x + a.R * in.spec.a.o + d - R_b * in.spec.b.o, R_b});
  }
  return in;
}

}  // namespace halfway::bench
