#include "bench/inputs.hpp"

#include <cmath>
#include <random>

namespace halfway::bench {
namespace {

/// std::uniform_real_distribution may differ between standard libraries; this does not.
class Generator {
 public:
  double uniform(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
  Vec3<double> vector(double size) {
    const double x = uniform(-size, size), y = uniform(-size, size), z = uniform(-size, size);
    return {x, y, z};
  }
  Vec3<double> direction() {
    Vec3<double> v = vector(1);
    while (v.norm() < 0.2 || v.norm() > 1) v = vector(1);
    return v.normalized();
  }
  Mat3<double> rotation(double phi) { return so3::exp<double>(phi * direction()); }

 private:
  std::mt19937_64 engine_{2011};
};

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
  Generator g;
  Inputs in;
  in.spec.kind = kind;
  in.spec.xi = xi;
  Eigen::MatrixXd K = stiffness(g, strain_count(kind));
  if (block_diagonal && kind == Kind::linear_angular) {
    K.topRightCorner(3, 3).setZero();
    K.bottomLeftCorner(3, 3).setZero();
  }
  in.spec.law = reference::LinearSpec{K, false};
  in.spec.a = {g.vector(0.5), g.rotation(1.1)};
  in.spec.b = {g.vector(0.5), g.rotation(0.7)};
  for (int i = 0; i < kPoses; ++i) {
    const Pose<double> a{g.vector(1), g.rotation(g.uniform(0, 3))};
    const double phi = 1e-3 * std::pow(3e3, g.uniform(0, 1));
    const Mat3<double> R_b = a.R * in.spec.a.H * g.rotation(phi) * in.spec.b.H.transpose();
    const Vec3<double> d = g.vector(0.3);
    in.a.push_back(a);
    in.b.push_back({a.x + a.R * in.spec.a.o + d - R_b * in.spec.b.o, R_b});
  }
  return in;
}

}  // namespace halfway::bench
