#include "verify/oracle/probes.hpp"

#include "reference/numbers/random.hpp"

namespace halfway::verify {
namespace {

using reference::Generator;

constexpr double kLeastAngle = 0.1;  ///< rad, of ends and poses: nothing accidentally aligned

/// Symmetric positive definite, eigenvalues spread over 1 ... 100, no axis aligned.
Eigen::MatrixXd stiffness(Generator& g, int n) {
  Eigen::MatrixXd basis(n, n);
  for (double& x : basis.reshaped()) x = g.uniform(-1, 1);
  // Gram-Schmidt, since K takes no harm from rounding and Householder's takes eight seconds to compile.
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < i; ++j) basis.col(i) -= basis.col(j).dot(basis.col(i)) * basis.col(j);
    basis.col(i).normalize();
    K += std::pow(100.0, (i + g.uniform(0.1, 0.9)) / n) * basis.col(i) * basis.col(i).transpose();
  }
  return (K + K.transpose()) / 2;
}

}  // namespace

std::vector<Probe> probes(const Entry& entry, Kind kind, int count, double largest_phi) {
  Generator g(20111);
  std::vector<Probe> out;
  for (int i = 0; i < count; ++i) {
    Probe probe;
    probe.spec.kind = kind;
    static_cast<Parameters&>(probe.spec) = entry.probe;
    Eigen::MatrixXd K = stiffness(g, strain_count(kind));
    if (entry.block_diagonal_law_only && kind == Kind::linear_angular) {
      K.topRightCorner(3, 3).setZero();
      K.bottomLeftCorner(3, 3).setZero();
    }
    probe.spec.law = reference::LinearSpec{K, false};
    probe.spec.a = {g.vector(0.7), g.rotation(kLeastAngle, 2)};
    probe.spec.b = {g.vector(0.7), g.rotation(kLeastAngle, 2)};
    probe.a = {g.vector(2), g.rotation(kLeastAngle, 3)};
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
