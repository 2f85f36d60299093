#include "verify/probes.hpp"

#include <random>

namespace halfway::verify {
namespace {

class Generator {
 public:
  double uniform(double low, double high) { return low + (high - low) * double(engine_() >> 11) * 0x1p-53; }
  Vec3<double> vector(double size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  Vec3<double> direction() {
    Vec3<double> v = vector(1);
    while (v.norm() < 0.2) v = vector(1);
    return v.normalized();
  }
  Mat3<double> rotation(double largest_phi) {
    // Two statements: compilers order the factors of a product freely.
    const Vec3<double> axis = direction();
    const double phi = uniform(0.1, largest_phi);
    return so3::exp<double>(phi * axis);
  }

 private:
  std::mt19937_64 engine_{20111};
};

/// Symmetric positive definite, eigenvalues spread over 1 ... 100, no axis aligned.
Eigen::MatrixXd stiffness(Generator& g, int n) {
  Eigen::MatrixXd basis(n, n);
  for (double& x : basis.reshaped()) x = g.uniform(-1, 1);
  const Eigen::MatrixXd Q = basis.householderQr().householderQ();
  Eigen::VectorXd k(n);
  for (int i = 0; i < n; ++i) k[i] = std::pow(100.0, (i + g.uniform(0.1, 0.9)) / n);
  const Eigen::MatrixXd K = Q * k.asDiagonal() * Q.transpose();
  return (K + K.transpose()) / 2;
}

}  // namespace

std::vector<Probe> probes(const Entry& entry, Kind kind, int count, double largest_phi) {
  Generator g;
  std::vector<Probe> out;
  for (int i = 0; i < count; ++i) {
    Probe probe;
    probe.spec.kind = kind;
    probe.spec.xi = entry.probe_xi;
    Eigen::MatrixXd K = stiffness(g, strain_count(kind));
    if (entry.block_diagonal_law_only && kind == Kind::linear_angular) {
      K.topRightCorner(3, 3).setZero();
      K.bottomLeftCorner(3, 3).setZero();
    }
    probe.spec.law = reference::LinearSpec{K, false};
    probe.spec.a = {g.vector(0.7), g.rotation(2)};
    probe.spec.b = {g.vector(0.7), g.rotation(2)};
    probe.a = {g.vector(2), g.rotation(3)};
    probe.phi = largest_phi * (i + 1) / count;
    const Mat3<double> P_a = probe.a.R * probe.spec.a.H;
    const Mat3<double> P_b = P_a * so3::exp<double>(probe.phi * g.direction());
    probe.b.R = P_b * probe.spec.b.H.transpose();
    probe.b.x = probe.a.x + probe.a.R * probe.spec.a.o + g.vector(0.3) - probe.b.R * probe.spec.b.o;
    out.push_back(probe);
  }
  return out;
}

}  // namespace halfway::verify
